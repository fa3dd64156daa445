//! Descriptions out of two flat tables, one of texts and one of bytes: a compiler takes far longer for values within values, and for each number
//! that stands in a list. For the code that the macro generates; what is not in the tables ends the evaluation of the constant.
//!
//! A number takes seven bits a byte, the lowest first; all bytes but its last have the eighth bit set. A text is its number in the table of texts, and what
//! may be missing is one more than itself, or zero. The order: actions, words, ends, and then the chart with its name, partial grafcets, macro-steps, steps,
//! transitions and named conditions, each as its reader takes it.

use core::marker::PhantomData;

use super::{Action, Any, Description, Dialect, Let, MacroStep, Partial, Step, Transition};

/// One of the flags of a step: it is initial.
pub const INITIAL: u8 = 1;
/// The same: it carries the activation link.
pub const LINKED: u8 = 2;

/// What the macro writes of a chart. These constants of an `impl` are computed where they are used, so the tables cost a program nothing that
/// does not ask for its description.
pub trait Tables {
    /// Each text once.
    const TEXTS: &'static [&'static str];
    /// All numbers.
    const NUMBERS: &'static [u8];
}

/// What stands in the tables of a chart, of each kind so many. Words are what lists of texts are made of, ends what lists of steps are made of.
pub struct Described<
    T,
    const ACTIONS: usize,
    const WORDS: usize,
    const ENDS: usize,
    const PARTIALS: usize,
    const MACROS: usize,
    const STEPS: usize,
    const TRANSITIONS: usize,
    const LETS: usize,
>(PhantomData<T>);

/// Reads one after the other, and the lists from where the last one has ended.
#[derive(Clone, Copy)]
struct Reader {
    texts: &'static [&'static str],
    numbers: &'static [u8],
    /// Where the next number begins. The compiler runs this: an index costs it far less than a shorter slice.
    at: usize,
    actions: &'static [Action<'static>],
    words: &'static [&'static str],
    ends: &'static [usize],
}

/// Takes the first ones of a list.
macro_rules! take {
    ($list:expr, $count:expr) => {{
        match $count {
            0 => &[],
            count => {
                let (own, later) = $list.split_at(count);
                $list = later;
                own
            }
        }
    }};
}

// The fields of a struct are read in the order in which they are written here, whatever their order in its declaration.
impl Reader {
    const fn number(&mut self) -> usize {
        let (mut number, mut shift) = (0, 0);
        loop {
            let byte = self.numbers[self.at];
            self.at += 1;
            number |= ((byte & 0x7f) as usize) << shift;
            if byte & 0x80 == 0 {
                return number;
            }
            shift += 7;
        }
    }

    const fn text(&mut self) -> &'static str {
        self.texts[self.number()]
    }

    const fn words(&mut self) -> &'static [&'static str] {
        take!(self.words, self.number())
    }

    const fn ends(&mut self) -> &'static [usize] {
        take!(self.ends, self.number())
    }

    const fn action(&mut self) -> Action<'static> {
        Action::new(self.text(), self.text(), self.text(), self.text())
    }

    const fn partial(&mut self) -> Partial<'static> {
        Partial { name: self.text(), enclosed_by: self.number().checked_sub(1), doc: self.text() }
    }

    const fn macro_step(&mut self) -> MacroStep<'static> {
        let (name, outer) = (self.text(), self.number().checked_sub(1));
        MacroStep { name, outer, entry: self.number(), exit: self.number(), doc: self.text() }
    }

    const fn step(&mut self) -> Step<'static> {
        let (name, flags) = (self.text(), self.number());
        Step {
            name,
            initial: flags & INITIAL as usize != 0,
            linked: flags & LINKED as usize != 0,
            partial: self.number(),
            expansion: self.number().checked_sub(1),
            actions: take!(self.actions, self.number()),
            within: self.text(),
            forces: self.words(),
        }
    }

    const fn transition(&mut self) -> Transition<'static> {
        let (name, condition) = (self.text(), self.text());
        let (sources, targets, clearing) = (self.ends(), self.ends(), self.words());
        let any = match self.number() {
            0 => None,
            _ => Some(Any { steps: self.ends(), except: self.words() }),
        };
        Transition { name, sources, any, targets, condition, clearing }
    }

    const fn named(&mut self) -> Let<'static> {
        Let { name: self.text(), text: self.text(), doc: self.text() }
    }
}

/// A function that reads so many, and hands on the reader.
macro_rules! list {
    ($name:ident: $one:ident -> $ty:ty, $empty:expr) => {
        const fn $name<const N: usize>(mut reader: Reader) -> ([$ty; N], Reader) {
            let mut all = [$empty; N];
            let mut number = 0;
            while number < N {
                all[number] = reader.$one();
                number += 1;
            }
            (all, reader)
        }
    };
}

list!(actions: action -> Action<'static>, Action::new("", "", "", ""));
list!(texts: text -> &'static str, "");
list!(numbers: number -> usize, 0);
list!(partials: partial -> Partial<'static>, Partial::new(""));
list!(macros: macro_step -> MacroStep<'static>, MacroStep::new("", 0, 0));
list!(steps: step -> Step<'static>, Step::new("", 0, &[], &[]));
list!(transitions: transition -> Transition<'static>, Transition::new("", &[], &[], "", &[]));
list!(lets: named -> Let<'static>, Let::new("", ""));

impl<
    T: Tables,
    const ACTIONS: usize,
    const WORDS: usize,
    const ENDS: usize,
    const PARTIALS: usize,
    const MACROS: usize,
    const STEPS: usize,
    const TRANSITIONS: usize,
    const LETS: usize,
> Described<T, ACTIONS, WORDS, ENDS, PARTIALS, MACROS, STEPS, TRANSITIONS, LETS>
{
    // Each list with the reader after it, and then alone: a constant that others borrow is linked as a whole.
    const READ_ACTIONS: ([Action<'static>; ACTIONS], Reader) =
        actions(Reader { texts: T::TEXTS, numbers: T::NUMBERS, at: 0, actions: &[], words: &[], ends: &[] });
    const ACTIONS: [Action<'static>; ACTIONS] = Self::READ_ACTIONS.0;
    const READ_WORDS: ([&'static str; WORDS], Reader) = texts(Self::READ_ACTIONS.1);
    const WORDS: [&'static str; WORDS] = Self::READ_WORDS.0;
    const READ_ENDS: ([usize; ENDS], Reader) = numbers(Self::READ_WORDS.1);
    const ENDS: [usize; ENDS] = Self::READ_ENDS.0;
    const CHART_FROM: Reader =
        Reader { actions: &Self::ACTIONS, words: &Self::WORDS, ends: &Self::ENDS, ..Self::READ_ENDS.1 };
    const NAME: (&'static str, Reader) = {
        let mut reader = Self::CHART_FROM;
        (reader.text(), reader)
    };
    const READ_PARTIALS: ([Partial<'static>; PARTIALS], Reader) = partials(Self::NAME.1);
    const PARTIALS: [Partial<'static>; PARTIALS] = Self::READ_PARTIALS.0;
    const READ_MACROS: ([MacroStep<'static>; MACROS], Reader) = macros(Self::READ_PARTIALS.1);
    const MACROS: [MacroStep<'static>; MACROS] = Self::READ_MACROS.0;
    const READ_STEPS: ([Step<'static>; STEPS], Reader) = steps(Self::READ_MACROS.1);
    const STEPS: [Step<'static>; STEPS] = Self::READ_STEPS.0;
    const READ_TRANSITIONS: ([Transition<'static>; TRANSITIONS], Reader) = transitions(Self::READ_STEPS.1);
    const TRANSITIONS: [Transition<'static>; TRANSITIONS] = Self::READ_TRANSITIONS.0;
    const LETS: [Let<'static>; LETS] = lets(Self::READ_TRANSITIONS.1).0;

    const SFC: Description<'static> = Description {
        name: Self::NAME.0,
        dialect: Dialect::Sfc,
        partials: &Self::PARTIALS,
        macros: &Self::MACROS,
        steps: &Self::STEPS,
        transitions: &Self::TRANSITIONS,
        lets: &Self::LETS,
    };
    const GRAFCET: Description<'static> = Description { dialect: Dialect::Grafcet, ..Self::SFC };

    /// The description of an SFC. It is a function, as a check of a constant computes the constants that it names, which takes seconds for a long chart.
    #[must_use]
    pub const fn sfc() -> Description<'static> {
        Self::SFC
    }

    /// The description of a GRAFCET.
    #[must_use]
    pub const fn grafcet() -> Description<'static> {
        Self::GRAFCET
    }
}

#[cfg(test)]
mod tests {
    use super::{Described, INITIAL, LINKED, Reader, Tables};
    use crate::description::{Action, Any, Description, Dialect, Let, MacroStep, Partial, Step, Transition};

    const NOTHING: Reader = Reader { texts: &[], numbers: &[], at: 0, actions: &[], words: &[], ends: &[] };

    #[test]
    fn a_number_takes_as_many_bytes_as_it_needs() {
        let mut reader = Reader { numbers: &[0, 127, 0x80, 1, 0xff, 0x7f, 0x80, 0x80, 1], ..NOTHING };
        let numbers: [usize; 5] = core::array::from_fn(|_| reader.number());
        assert_eq!(numbers, [0, 127, 128, 16383, 16384]);
        assert_eq!(reader.at, reader.numbers.len());
    }

    struct Chart;

    impl Tables for Chart {
        const TEXTS: &'static [&'static str] =
            &["", "N", "a", "L", "5s", "F {A}", "G {*}", "A", "B", "C", "x = 1", "go"];
        #[rustfmt::skip]
        const NUMBERS: &'static [u8] = &[
            // Actions, words, ends.
            1, 0, 0, 2,  3, 4, 11, 2,
            5, 6, 10, 9,
            0, 1, 2, 1, 0, 1,
            // The chart, its partial grafcets, its macro-step, its steps.
            11,
            0, 0, 0,  9, 3, 2,
            8, 0, 1, 2, 11,  9, 1, 0, 0, 7,
            7, INITIAL, 0, 0, 1, 0, 0,
            8, LINKED, 1, 1, 1, 4, 2,
            9, INITIAL | LINKED, 0, 2, 0, 0, 0,
            // Its transitions and its named condition.
            0, 2, 1, 2, 1, 0,
            11, 2, 0, 1, 0, 1, 2, 1,
            11, 2, 4,
        ];
    }

    #[test]
    fn each_gets_its_own() {
        const CHART: Description<'static> = Described::<Chart, 2, 4, 6, 2, 2, 3, 2, 1>::sfc();
        const A: [Action<'static>; 1] = [Action::new("N", "", "", "a")];
        const B: [Action<'static>; 1] = [Action::new("L", "5s", "go", "a")];
        const EXPECTED: Description<'static> = Description {
            name: "go",
            dialect: Dialect::Sfc,
            partials: &[Partial::new(""), Partial::new("C").enclosed_by(2).documented("a")],
            macros: &[MacroStep::new("B", 1, 2).documented("go"), MacroStep::new("C", 0, 0).inside(0).documented("A")],
            steps: &[
                Step::new("A", 0, &A, &[]).initial(),
                Step::new("B", 1, &B, &["F {A}", "G {*}"]).linked().inside(0).within("5s"),
                Step::new("C", 0, &[], &[]).initial().linked().inside(1),
            ],
            transitions: &[
                Transition::new("", &[0], &[1, 2], "a", &["x = 1"]),
                Transition {
                    any: Some(Any { steps: &[0, 1], except: &["C"] }),
                    ..Transition::new("go", &[], &[1], "a", &[])
                },
            ],
            lets: &[Let::new("go", "a").documented("5s")],
        };
        assert_eq!(CHART, EXPECTED);
        assert_eq!(
            Described::<Chart, 2, 4, 6, 2, 2, 3, 2, 1>::grafcet(),
            Description { dialect: Dialect::Grafcet, ..EXPECTED }
        );
    }
}
