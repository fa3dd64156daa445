//! Good charts of every kind that people draw: none of them may get an error or a warning.
//!
//! A false alarm counts as much as a missed fault, so a rule that speaks here is wrong, or the chart is and gets mended.
#![deny(warnings)]
#![allow(clippy::manual_range_contains, reason = "a range is Rust that the checker does not look into")]
#![allow(dead_code, reason = "the charts are compiled, not all are driven")]

mod charts;

use std::fs;

/// A module a file of `tests/good`, and the list of their names.
macro_rules! good {
    ($($chart:ident)*) => {
        $(mod $chart { include!(concat!("good/", stringify!($chart), ".rs")); })*
        const GOOD: &[(&str, &str)] =
            &[$((stringify!($chart), include_str!(concat!("good/", stringify!($chart), ".rs")))),*];
    };
}

good! {
    abort_branches alternating_pumps batch_recipe bottle_filling buffer busy car_wash carton_line commissioning
    debounce drill_station elevator emergency_stop garage_gate handshake hierarchy interlocked jumps
    latched_requests light_switch machining_cell macro_steps modes mutual_interlock nested operating_modes overlapping_parts
    packaging_line parking pipeline press protocol qualifiers qualifiers_grafcet rendezvous retry
    reversing_drive rotary_plant selections_of_rust shared_crane shared_crane_grafcet sorting_line star_delta stop_anywhere supervised_tank
    tank_levels
    thirty_programmes token_ring traffic_light two_boxes two_hand_press washing_machine watchdog
}

/// The same without rustc, for the message.
#[test]
fn nothing_is_said_about_a_good_chart() {
    let mut said = String::new();
    for (name, text) in GOOD {
        let charts = charts::charts(text);
        assert!(!charts.is_empty(), "{name} has no chart");
        for chart in charts {
            let code = charts::expand(chart).to_string();
            let messages = code.split('"').filter(|literal| literal.contains("[grafcet::"));
            messages.for_each(|message| said.extend([name, ": ", message, "\n"]));
            assert!(!code.contains("compile_error") || said.contains(name), "{name} is refused: {code}");
        }
    }
    assert!(said.is_empty(), "\n{said}");
}

#[test]
fn every_file_is_compiled() {
    for file in fs::read_dir("tests/good").expect("the folder of charts") {
        let name = file.expect("a file").file_name().into_string().expect("a name in UTF-8");
        let listed = GOOD.iter().any(|(chart, _)| name.strip_suffix(".rs") == Some(chart));
        assert!(listed, "{name} is not compiled: name it in tests/good.rs");
    }
}
