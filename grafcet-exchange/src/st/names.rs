//! Names that structured text takes: no keyword, no capital letter that tells two apart, no letter beyond ASCII.

use std::collections::{BTreeMap, BTreeSet};

/// What cannot be a name: keywords, types, standard functions and function blocks of IEC 61131-3, and what CODESYS and TIA add.
const TAKEN: &str = "
    abs abstract acos action add adr and any array asin at atan atan2 bcd_to_bool begin block_db bool by byte case ceil char class concat configuration constant
    continue cos ctd ctu ctud data_block date date_and_time delete dint div do dt dword else elsif end_action end_case end_configuration end_for
    end_function end_function_block end_if end_interface end_method end_namespace end_program end_repeat end_resource end_step end_struct
    end_transition end_type end_var end_while en eno eq exit exp expt extends false final find floor for from f_edge f_trig function
    function_block ge goto gt if implements init_step initial_step insert int interface internal interval ldate ldt le left len limit lint ln log lreal lt ltime ltod
    lword max method mid min mod move mul mux namespace ne non_retain not null of on on_change or overlap override param pi pointer priority private program protected
    public r_edge r_trig read_only read_write real ref ref_to reference region repeat replace resource retain return right rol ror round rs sel shl shr sin
    single sint sizeof sqrt sr step string struct sub super tan task then this time time_of_day time_to_dint to tod tof ton tp transition true trunc type udint uint ulint
    until usint using var var_access var_config var_external var_global var_in_out var_input var_output var_temp wchar while with word
    wstring xor current_time st ld r s
    sint_to_byte usint_to_byte int_to_word uint_to_word dint_to_dword udint_to_dword lint_to_lword ulint_to_lword
    byte_to_sint byte_to_usint word_to_int word_to_uint dword_to_dint dword_to_udint lword_to_lint lword_to_ulint";

/// Gives names, each once.
#[derive(Default)]
pub(crate) struct Names {
    /// In small letters.
    given: BTreeSet<String>,
    /// What has another name than in the chart.
    pub(crate) renamed: BTreeMap<String, String>,
}

impl Names {
    pub(crate) fn new() -> Self {
        Self { given: TAKEN.split_whitespace().map(str::to_owned).collect(), renamed: BTreeMap::new() }
    }

    /// A name of the chart, as it is if it can be.
    pub(crate) fn of_chart(&mut self, wanted: &str) -> String {
        let name = self.own(wanted);
        if name != wanted {
            self.renamed.insert(wanted.to_owned(), name.clone());
        }
        name
    }

    /// A step of the chart, which stands in the name space of variables: where one of these has its name, it gets `Step` after it.
    pub(crate) fn of_step(&mut self, wanted: &str) -> String {
        if !self.given.contains(&plain(wanted).to_lowercase()) {
            return self.of_chart(wanted);
        }
        let name = self.own(&format!("{wanted}Step"));
        self.renamed.insert(wanted.to_owned(), name.clone());
        name
    }

    /// A name that the translation needs.
    pub(crate) fn own(&mut self, wanted: &str) -> String {
        let plain = plain(wanted);
        let mut name = plain.clone();
        let mut number = 2;
        while !self.given.insert(name.to_lowercase()) {
            name = format!("{plain}_{number}");
            number += 1;
        }
        name
    }
}

/// Letters of ASCII, digits and single underscores between them; a letter first.
fn plain(wanted: &str) -> String {
    let mut plain = String::new();
    for letter in wanted.chars() {
        let letter = if letter.is_ascii_alphanumeric() { letter } else { '_' };
        if letter != '_' || !plain.ends_with('_') && !plain.is_empty() {
            plain.push(letter);
        }
    }
    let plain = plain.trim_end_matches('_');
    match plain.chars().next() {
        Some(first) if first.is_ascii_alphabetic() => plain.to_owned(),
        _ => format!("x{plain}"),
    }
}

#[cfg(test)]
mod tests {
    use super::Names;

    #[test]
    fn names_that_structured_text_takes() {
        let mut names = Names::new();
        let wanted = ["go", "Go", "GO", "mod", "größe", "_a__b_", "1", "S1"];
        let given = wanted.map(|name| names.of_chart(name));
        assert_eq!(given, ["go", "Go_2", "GO_3", "mod_2", "gr_e", "a_b", "x1", "S1"]);
        assert_eq!(names.renamed.len(), 6);
    }
}
