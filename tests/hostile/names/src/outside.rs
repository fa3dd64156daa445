//! Names that the generated items for a look from outside have, too.

use grafcet::grafcet;

#[allow(dead_code)]
/// A trait with the same methods as those that are generated.
trait Asked {
    fn name(&self) -> u8 {
        1
    }
    fn vars(&self) -> u8 {
        2
    }
    fn is_exactly(&self, _: &[u8]) -> u8 {
        3
    }
    fn fmt(&self) -> u8 {
        4
    }
}
impl<T> Asked for T {}

#[allow(dead_code)]
struct Display;
#[allow(dead_code)]
struct Formatter;
#[allow(dead_code)]
const DEFAULT: u8 = 0;

grafcet! {
    #[allow(non_snake_case, non_camel_case_types)]
    pub sfc Asked_ {
        #![allow(grafcet::unused_input, grafcet::unused_variable)]
        input DEFAULT, name, f, steps: bool;
        output q: bool;
        var vars, copied, r#in, self_: u8;
        var var_vars: bool;
        initial step name_ { q; }
        step fmt { P1 vars = vars + 1; P1 r#in = 4; }
        step DEFAULT_;
        step vars_;
        name_ -[name]-> fmt -[DEFAULT && f]-> DEFAULT_ -[steps]-> vars_ -[!steps]-> name_;
    }
}

mod same {
    use grafcet::grafcet;

    grafcet! {
        pub sfc Steps {
            #![allow(grafcet::unused_variable)]
            input go: bool;
            output q: bool;
            var count: u8;
            initial step name { q; }
            step vars { P1 count = count + 1; }
            step is_exactly;
            name -[fmt: go]-> vars -[self_: go]-> is_exactly -[name: go]-> name;
        }
    }
}

grafcet! {
    #[allow(non_camel_case_types)]
    pub sfc r#type {
        input go: bool;
        output q: bool;
        var count: u8;
        initial step A { q if count > 0; }
        step B { P1 count = count + 1; }
        A -[go]-> B -[!go]-> A;
    }
}

#[test]
fn names_are_no_obstacle() {
    let mut chart = Asked_::new();
    chart.cycle(&Asked_Inputs::DEFAULT);
    chart.cycle(&Asked_Inputs { name: true, ..Asked_Inputs::DEFAULT });
    assert!(chart.is_exactly(&[Asked_Step::fmt]));
    assert_eq!((chart.vars().vars, chart.vars().r#in, chart.vars().var_vars), (1, 4, false));
    assert_eq!((Asked_Step::fmt.name(), Asked_Step::DEFAULT_.to_string()), ("fmt", "DEFAULT_".to_owned()));
    let step = same::StepsStep::name;
    assert_eq!((step.name(), same::StepsStep::is_exactly.to_string()), ("name", "is_exactly".to_owned()));
    assert_eq!(same::StepsTransition::Fmt.name(), "Fmt");
    assert_eq!(same::Steps::new().vars().count, 0);
    let vars: typeVars = r#type::new().vars();
    assert_eq!(vars.count, 0);
}
