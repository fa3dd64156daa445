grafcet! {
    /// One active step.
    pub sfc Plain {
        #![allow(grafcet::unused_variable, grafcet::set_without_reset, grafcet::reset_without_set)]
        input x_inputs, x_now, x_actions, x_self, x_before, x_after, x_outputs, x_value, x_first, x_step, x_elapsed, x_steps, x_again: bool;
        input x_forced, x_forced0: bool;
        forceable;
        output x_situation, x_stable, x_entered, x_reset, x_q: bool;
        var x_last: bool;
        var x_active: u8;

        initial step Off { N x_situation; P1 x_active = x_active + 1; }
        step On { N x_stable; S x_entered; R x_reset; N x_q if x_inputs || x_now && x_value && x_forced != x_forced0; N x_last = x_last || x_step && x_elapsed; }

        Off -[x_inputs && !x_now || x_actions || x_self]-> On -[x_before || x_after || x_outputs && x_first]-> Off;
        On -[rising(x_value) || x_steps && x_again && Off.X]-> On;
    }
}

grafcet! {
    /// Parallel steps, times, edges, delays, calls, blocks.
    pub sfc Timed {
        #![allow(grafcet::unused_variable, grafcet::set_without_reset)]
        input x_inputs, x_now, x_actions, x_before, x_after, x_outputs, x_value, x_first, x_input, x_done, x_elapsed, x_settled, x_soonest: bool;
        input x_since, x_time, x_ticks, x_duration, x_restart, x_left, x_flag: u16;
        output x_situation, x_region, x_region_0, x_region_1, x_set, x_steps: bool;
        output x_speed: u16;
        var x_kept, x_edge, x_memory, x_timer: bool;
        var x_count, x_number: u16;
        var x_limit: time = 1s;
        param x_params: time = 2s;
        param x_hot: u16 = 1;
        action x_call(x_phase: u16, x_inputs: u16);
        action x_scan();
        forceable;

        initial step Off { N x_situation; P0 x_scan(); }
        step One { N x_call(x_since, x_time); L x_limit x_region; D 2s x_set; SD x_params x_steps; x_kept; R x_region_0; x_speed = x_ticks + x_hot; }
        step Two { N x_call(x_restart, x_left); S x_region_0; P1 x_count = x_count + x_flag; P { x_number += 1; if x_number > x_hot { x_number = 0; } } }
        step Three { N x_scan(); x_memory; SL 1s x_timer; DS 1s x_edge; R x_region_1; }
        step Four { P1 { let x_inputs = x_count; x_count = x_inputs + 1; } S x_region_1; }

        Off -[rising(x_inputs && x_now)]-> (One, Two);
        (One, Two) -[falling(x_value) && x_first || x_params/One && 1s/x_before/500ms || x_actions]-> (Three, Four);
        (Three, Four) -[Three.T >= x_limit && x_duration > 1 || x_input && x_done && x_elapsed || x_after]-> Off;
        (Three, Four) -[x_settled && x_soonest && x_outputs]-> Off;
    }
}

grafcet! {
    /// So long that tables say what there is to do in a step.
    pub sfc Small {
        optimize size;
        input x_kind, x_found, x_once, x_table, x_after: bool;
        output x_kinds: bool;

        initial step S0; step S1 { N x_kinds; } step S2; step S3; step S4 { N x_kinds; } step S5; step S6; step S7 { N
        x_kinds; } step S8; step S9; step S10 { N x_kinds; } step S11; step S12; step S13 { N x_kinds; } step S14; step S15;
        step S16 { N x_kinds; } step S17; step S18; step S19 { N x_kinds; } step S20;

        S0 -[x_kind]-> S1 -[x_found && !x_once]-> S2 -[x_kind]-> S3 -[x_found && !x_once]-> S4 -[x_kind]-> S5 -[x_found && !x_once]-> S6
        -[x_kind]-> S7 -[x_found && !x_once]-> S8 -[x_kind]-> S9 -[x_found && !x_once]-> S10 -[x_kind]-> S11 -[x_found && !x_once]-> S12
        -[x_kind]-> S13 -[x_found && !x_once]-> S14 -[x_kind]-> S15 -[x_found && !x_once]-> S16 -[x_kind]-> S17 -[x_found && !x_once]->
        S18 -[x_table]-> S19 -[x_after]-> S20 -[x_kind]-> S0;
    }
}

grafcet! {
    /// The same under the rules of IEC 60848.
    pub grafcet Search {
        #![allow(grafcet::stuck_join)]
        input x_inputs, x_now, x_actions, x_before, x_after, x_outputs, x_value, x_first, x_input, x_fresh, x_stable, x_evolutions_left: bool;
        input x_elapsed, x_settled, x_due, x_active: u16;
        output x_situation, x_region, x_called, x_set: bool;
        output x_next, x_association: u16;
        var x_kept: bool;
        var x_count, x_number: u16;
        param x_params: time = 2s;
        action x_call(x_phase: u16, x_now: u16);
        max_evolutions 5;
        forceable;

        partial Above {
            initial step Ready;
            step Hold { force Below {*}; }
            Ready -[rising(x_inputs) && x_now]-> Hold -[falling(x_now) || x_kept]-> Ready;
        }
        partial Below {
            initial step Off { N x_situation; P0 x_call(x_elapsed, x_due); x_kept; N x_call(x_active, x_number); }
            step One { L 1s x_region if x_value; S x_called if !x_first; on rising(x_value) x_count = x_count + 1; N x_call(x_elapsed, x_settled); }
            step Two { D x_params x_set; R x_called if x_first; P1 x_next = x_elapsed; P0 { let x_next = x_settled; x_association = x_next; } }
            macro step Both { entry step In; exit step Out; In -[x_first]-> Out; }
            Off -[x_actions]-> (One, Two);
            (One, Two) -[x_before && x_after || 1s/x_outputs/2s || x_fresh => x_number = x_number + 1]-> Both;
            Both -[Both.T > 1s && x_input && x_stable]-> Off;
            () -[rising(x_evolutions_left) => x_call(x_count, x_active)]-> Two;
        }
    }
}

grafcet! {
    /// With a bit for each step, in several bytes.
    pub grafcet Flags {
        #![allow(grafcet::deadlock)]
        encoding flags;
        forceable;
        input x_before, x_after, x_first_of_byte, x_byte, x_set, x_moved, x_steps: bool;
        output x_situation, x_state, x_on: bool;
        var x_count: u8;
        initial step A0 { x_situation if x_before && A1.X; }
        step A1; step A2 { x_state; } step A3; step A4; step A5; step A6; step A7; step A8; step A9; step B0;
        step B1; step B2; step B3; step B4; step B5; step B6; step B7; step B8; step B9; step C0 { x_on if x_set && x_byte; }
        step C1; step C2; step C3; step C4; step C5; step C6; step C7; step C8; step C9 { P1 { let x_byte = 2; x_count += x_byte; } }
        A0 -[x_before && !A1.X || x_after && A2.X]-> (A1, A2);
        (A1, A2) -[x_first_of_byte && A2.X]-> A3 -[x_byte]-> A4 -[x_set]-> A5 -[x_moved && x_count == 0]-> A6 -[x_steps]-> A7;
        A7 -[x_byte]-> A8 -[x_set]-> A9 -[x_byte]-> B0 -[x_set]-> B1 -[x_byte]-> B2 -[x_set]-> B3 -[x_byte]-> B4 -[x_set]-> B5;
        B5 -[x_byte]-> B6 -[x_set]-> B7 -[x_byte]-> B8 -[x_set]-> B9 -[x_byte]-> C0 -[!x_set]-> C1 -[x_byte]-> C2 -[x_set]-> C3;
        C3 -[x_byte]-> C4 -[x_set]-> C5 -[x_byte]-> C6 -[x_set]-> C7 -[x_byte]-> C8 -[x_before && x_set]-> C9 -[rising(x_set)]-> A0;
    }
}

grafcet! {
    /// What the modes, a recipe with ranges and what is assumed add.
    pub sfc Extras {
        #![allow(grafcet::unused_input)]
        modes;
        input x_a, x_b: bool;
        input x_mode: Mode in {Off, On};
        param x_limit: u16 in 1..=9 = 3;
        output x_q: bool;
        output x_level: u16;
        assume never x_a && x_b;
        initial step Idle { x_q if core::convert::identity(x_a) && x_b; }
        step Work within 5s { x_level = x_limit; N x_q if blink(500ms) && x_mode == Mode::On; }
        Idle -[x_a]-> Work -[x_b || Work.late]-> Idle;
        any -[x_mode == Mode::Off && x_a]-> Idle;
    }
}
