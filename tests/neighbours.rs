//! The neighbours of the charts in `tests/ui`: nearly the same, and right. All are compiled here, and their `main` is run;
//! the test `rules` sees to it that none is missing in the list.

/// A module a file, a test a module.
macro_rules! neighbours {
    ($($group:ident: $($chart:ident),*;)*) => {
        $($(
            mod $chart {
                include!(concat!("ui/", stringify!($group), "/", stringify!($chart), ".neighbour.rs"));

                #[test]
                fn $group() {
                    main();
                }
            }
        )*)*
    };
}

neighbours! {
    actions:
        bad_time, clearing_action, conflicting_values, mixed_modes, reset_without_set, set_without_reset,
        timed_contention, undriven_output, unused_action, unused_input, unused_param, unused_variable, write_race,
        wrong_target;
    conditions:
        always_true, combinational_circle, edge_in_assignation, event_without_edge, level_source_transition,
        never_true, overlapping_branches, possible_instability, reads_continuous, shadowed_branch, unstable,
        unused_let;
    drawing:
        duplicate_name, duplicate_transition, isolated_step, no_initial_step, repeated_step, reserved_name,
        several_initial_steps, sink_transition, source_transition, steps_without_transition,
        transitions_without_step, unknown_name, unknown_partial, unknown_step;
    evolution: dead_transition, deadlock, not_home, stuck_join, unreachable_step, unsafe_step;
    levels: allow, warnings;
    properties: property_undecided, property_violated, vacuous_assumption, vacuous_property;
    structure:
        enclosure_without_link, forced_enclosure, forced_step_outside, forcing_circle, init_without_initial,
        initial_without_effect, macro_entry_exit, two_masters;
}
