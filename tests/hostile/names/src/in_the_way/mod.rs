//! Items of the program that are called like locals and parameters of generated code might be: statics, constants, unit structs, variants
//! that a `use` brings in; and traits for all types whose methods are called like those that generated code calls.
//!
//! A binding that meets an item is a pattern of it, whoever wrote the binding. The test `bindings` looks at the names of all bindings, this
//! at what rustc makes of them.

/// The same item under each of the names.
macro_rules! all {
    ($item:ident) => {
        $item! {
            manual paused push semi_automatic acting actions active active_1 active_2 after after_0 after_1 after_2 again any_cleared before
            before_0 before_1 before_2 c copy d delay_0 done_flag_ds_x_edge done_flag_sd_x_steps
            done_flag_sl_x_timer due_clearing_6 duration edge0_now edge_before_0 edge_before_1 edge_before_2
            edge_before_3 edge_kept elapsed elapsed_param_0_1 ended enter_4 entered entered_off
            evolutions_left excluded_0 excluded_1 f falling_1 falling_now_1 first flag_ds_x_edge flag_n_x_call
            flag_n_x_kept flag_n_x_memory flag_n_x_scan flag_p0_x_scan flag_p_4 flag_sd_x_steps
            flag_sl_x_timer forced forced0 forced1 forced2 found from goes holds index input inputs is_x_kept
            kept kind last last_x_q left left_3 left_4 left_flag_n_x_call left_flag_n_x_scan macro_since_0
            moved moves name names new next next_x_association next_x_called next_x_count next_x_next
            next_x_number now number number_n_x_call one other other_branch outputs own_x_count p params
            passed phase q_4 q_x_call q_x_edge q_x_entered q_x_kept q_x_memory q_x_q q_x_reset q_x_scan
            q_x_situation q_x_stable q_x_steps q_x_timer reached refused reset_x_q reset_x_region_0
            reset_x_region_1 rising rising_0 rising_2 rising_3 rising_now_0 rising_now_2 rising_now_3 set
            set_x_q since since_3 since_before since_before_0 situation soonest state step steps test
            ticks_1000 ticks_2000 time to turned under value variables variant waiting was was_state written
            written_x_count
        }
    };
}

macro_rules! statics {
    ($($name:ident)*) => { $(static $name: u8 = 0;)* };
}

macro_rules! constants {
    ($($name:ident)*) => { $(const $name: bool = true;)* };
}

macro_rules! structs {
    ($($name:ident)*) => { $(struct $name;)* };
}

macro_rules! variants {
    ($($name:ident)*) => {
        enum Word { $($name),* }
        use Word::*;
    };
}

/// Traits for all types.
#[allow(
    clippy::wrong_self_convention,
    clippy::iter_not_returning_iterator,
    clippy::return_self_not_must_use,
    clippy::must_use_candidate
)]
pub mod methods {
    /// Methods of a trait that each type has.
    macro_rules! methods {
        (@ ($($self:tt)+) $name:ident) => {
            /// Something else.
            fn $name($($self)+) -> Other {
                Other
            }
        };
        (@@ $self:tt $($name:ident)*) => { $(methods! { @ $self $name })* };
        ($($self:tt)+) => {
            methods! { @@ ($($self)+)
                active_steps after copied cycle debug_set elapsed entry filter finish flatten force get init is_active is_exactly is_marked
                is_none is_same is_stable iter look map marked name next next_deadline of output pad params phase push region_0_ region_1_ remaining
                scan set_params since situation situation_ state steps take ticks unmarked unwrap_or_else update vars with wrapping_add write write_str
            }
        };
    }

    /// What these methods return.
    #[derive(Clone, Copy, Debug)]
    pub struct Other;

    /// Methods that are found before those which take a reference.
    pub trait ByValue: Sized {
        methods! { self }
    }

    impl<T> ByValue for T {}

    /// Methods that are found before those of slices on arrays.
    pub trait ByReference {
        methods! { &self }
    }

    impl<T: ?Sized> ByReference for T {}
}

macro_rules! by_value {
    ($($name:ident)*) => {
        use super::methods::ByValue;
    };
}

macro_rules! by_reference {
    ($($name:ident)*) => {
        use super::methods::ByReference;
    };
}

/// Charts beside these items.
macro_rules! beside {
    ($module:ident, $items:ident) => {
        /// Charts beside these items.
        #[allow(dead_code, non_upper_case_globals, non_camel_case_types, unused_imports)]
        pub mod $module {
            use grafcet::grafcet;

            use super::Mode;

            all!($items);

            include!("charts.rs");
        }
    };
}

/// Something to choose.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Mode {
    /// Nothing.
    #[default]
    Off,
    /// Something.
    On,
}

beside!(beside_statics, statics);
beside!(beside_constants, constants);
beside!(beside_structs, structs);
beside!(beside_variants, variants);
beside!(beside_methods_by_value, by_value);
beside!(beside_methods_by_reference, by_reference);

#[test]
fn runs() {
    let mut chart = beside_statics::Plain::new();
    assert!(chart.cycle(&beside_statics::PlainInputs::default()).x_situation);
    let mut chart = beside_constants::Plain::new();
    assert!(chart.cycle(&beside_constants::PlainInputs::default()).x_situation);
}
