//! The cycle functions of the examples as roots for the linker: `cargo xtask firmware` links each alone and looks for the
//! machinery of a panic.

#[cfg(feature = "roots")]
use core::panic::PanicInfo;

use grafcet::Phase;

use crate::{branch_on_result, cell, controller, line24v, motor, pick_and_place, recipe, stroke, tickless};

/// Carries out nothing.
pub struct Idle;

impl recipe::DyerActions for Idle {
    fn heat(&mut self, _: Phase, _: i16) {}
    fn drum(&mut self, _: Phase, _: u16) {}
}

impl controller::CalledActions for Idle {
    fn control(&mut self, _: Phase, _: i16, _: i16) {}
}

impl controller::RemoteActions for Idle {
    fn send(&mut self, _: Phase, _: controller::Message) {}
}

/// A static that holds a function, under a name that the linker knows.
macro_rules! roots {
    ($($name:ident: $function:ty = $value:expr;)*) => {$(
        #[expect(unsafe_code, reason = "a name without mangling")]
        #[unsafe(no_mangle)]
        static $name: $function = $value;
    )*};
}

roots! {
    root_of_motor: fn(&mut motor::Motor, &motor::MotorInputs) -> motor::MotorOutputs = motor::Motor::cycle;
    root_of_line24v: fn(&mut line24v::Line24V, &line24v::Line24VInputs) -> line24v::Line24VOutputs =
        line24v::Line24V::cycle;
    root_of_recipe: fn(&mut recipe::Dyer, &recipe::DyerInputs, u32, &mut Idle) -> recipe::DyerOutputs =
        recipe::Dyer::cycle;
    root_of_branch_on_result:
        fn(&mut branch_on_result::Sorter, &branch_on_result::SorterInputs) -> branch_on_result::SorterOutputs =
        branch_on_result::Sorter::cycle;
    root_of_cell: fn(&mut cell::Cell, &cell::CellInputs) -> cell::CellOutputs = cell::Cell::cycle;
    root_of_tickless: fn(&mut tickless::Crossing, &tickless::CrossingInputs, u32) -> tickless::CrossingOutputs =
        tickless::Crossing::cycle;
    root_of_stroke: fn(&mut stroke::Press, &stroke::PressInputs, u32) -> stroke::PressOutputs = stroke::Press::cycle;
    root_of_pick_and_place: fn(
        &mut pick_and_place::PickAndPlace,
        &pick_and_place::PickAndPlaceInputs,
        u32,
    ) -> pick_and_place::PickAndPlaceOutputs = pick_and_place::PickAndPlace::cycle;
    root_of_controller: (
        fn(&mut controller::Called, &controller::CalledInputs, &mut Idle) -> controller::CalledOutputs,
        fn(&mut controller::Remote, &controller::RemoteInputs, &mut Idle) -> controller::RemoteOutputs,
    ) = (controller::Called::cycle, controller::Remote::cycle);
    alone_controller: fn(&mut controller::Called, &controller::CalledInputs, &mut Idle) -> controller::CalledOutputs =
        controller::Called::cycle;
    root_of_a_panic: fn(&[u8], usize) -> u8 = |bytes, place| bytes[place];
}

/// The same with the recorder, for what it costs.
#[cfg(feature = "record")]
mod recorded {
    use grafcet::Ticks;
    use grafcet::record::{Memory, Recordable, Recorder};

    use super::{Idle, branch_on_result, cell, controller, line24v, motor, pick_and_place, recipe, stroke, tickless};

    type Recorded<C> = Recorder<C, Memory<&'static mut [u8]>>;

    /// Begins a recording and runs a cycle of it.
    type Both<C, A> = (
        fn(C, &'static mut [u8]) -> Option<Recorded<C>>,
        fn(&mut Recorded<C>, &<C as grafcet::Chart>::Inputs, u32, &mut A) -> <C as grafcet::Chart>::Outputs,
    );

    fn begin<C: Recordable>(chart: C, memory: &'static mut [u8]) -> Option<Recorded<C>> {
        Recorder::new(chart, memory).ok()
    }

    const fn both<A, C: for<'a> Recordable<Actions<'a> = A>>() -> Both<C, A> {
        (begin, |recorder, inputs, now, actions| recorder.cycle(inputs, Ticks::new(now), actions))
    }

    roots! {
        recorded_motor: Both<motor::Motor, ()> = both();
        recorded_line24v: Both<line24v::Line24V, ()> = both();
        recorded_branch_on_result: Both<branch_on_result::Sorter, ()> = both();
        recorded_cell: Both<cell::Cell, ()> = both();
        recorded_tickless: Both<tickless::Crossing, ()> = both();
        recorded_stroke: Both<stroke::Press, ()> = both();
        recorded_pick_and_place: Both<pick_and_place::PickAndPlace, ()> = both();
        recorded_recipe: Both<recipe::Dyer, Idle> =
            (begin, |recorder, inputs, now, actions| recorder.cycle(inputs, Ticks::new(now), actions));
        recorded_controller: Both<controller::Called, Idle> =
            (begin, |recorder, inputs, now, actions| recorder.cycle(inputs, Ticks::new(now), actions));
    }
}

/// What finds commands in bytes.
#[cfg(feature = "steer")]
mod steered {
    use grafcet::Chart;
    use grafcet::record::steer::{Answer, Command, Commands, command_len};

    use crate::cell::{Cell, CellStep};

    type Reading = Commands<Cell, [u8; command_len::<Cell>()], [CellStep; Cell::STEPS.len()]>;

    roots! {
        steered_cell: fn(&mut Reading, u8, u32) -> Option<Result<Command<'_, CellStep>, Answer>> = Reading::push;
    }
}

#[cfg(feature = "roots")]
#[panic_handler]
fn panicked(_: &PanicInfo<'_>) -> ! {
    loop {}
}
