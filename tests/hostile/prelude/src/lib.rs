//! Charts where every name of the prelude, and those of the crates that generated code uses, mean something else.
#![deny(warnings)]
#![allow(dead_code, missing_docs, non_camel_case_types, unused_macros, reason = "the names are there to be in the way")]

mod shadowed;
mod without;

#[test]
fn runs() {
    let mut shadowed = shadowed::Motor::new();
    shadowed.cycle(&shadowed::MotorInputs { on: false, off: false });
    assert!(shadowed.cycle(&shadowed::MotorInputs { on: true, off: false }).relay);
    assert!(shadowed.is_active(shadowed::MotorStep::On));
    let mut without = without::Named::default();
    without.cycle(&Default::default());
    let q = without.cycle(&without::NamedInputs { Vec: true, ..Default::default() });
    assert!(q.heapless && !q.usize);
    assert_eq!(format!("{:?}", without::Oven::new().situation()), "{Ready, Off}");
}
