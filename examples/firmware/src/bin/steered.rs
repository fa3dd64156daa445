//! A tank that is steered while it runs: frames go out over the serial line, and commands come in over it, from `cargo grafcet watch --steer` or whoever knows
//! the format. The program carries out what it takes and says what became of it; by hand it forces in the modes manual and paused alone. `cargo xtask web live`
//! steers it in a browser.
#![no_std]
#![no_main]

use core::convert::Infallible;
use core::panic::PanicInfo;

use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::peripheral::{Peripherals, SCB, SYST};
use cortex_m_rt::{entry, exception};
use grafcet::record::steer::{Answer, Command, Commands, Mode, Refused, Wanted, command_len};
use grafcet::record::wire::{Wire, wire_len};
use grafcet::record::{Recorder, TooSmall};
use grafcet::{Chart, grafcet};

grafcet! {
    /// A tank that is filled, heated and drained, again and again.
    sfc Tank {
        forceable;
        modes;
        input full, hot, empty: bool;
        output inlet, heater, outlet, lamp: bool;

        initial step Ready { N lamp; }
        step Fill { N inlet; }
        step Heat { N heater; }
        step Drain { N outlet; }

        Ready -[empty && 500ms/Ready]-> Fill -[full]-> Heat -[hot && 1s/Heat]-> Drain -[empty]-> Ready;
    }
}

/// The time of a cycle in milliseconds, and in ticks of the board's clock.
const CYCLE: u32 = 10;
const TICKS: u32 = 120_000;

/// The state is told so often, in milliseconds.
const TELLS: u32 = 500;

/// So many cycles old a command is at most: three seconds.
const OLDEST: u32 = 300;

/// A chart whose record goes over the serial line.
type Running = Recorder<Tank, Wire<Serial, [u8; wire_len::<Tank>()]>>;

#[entry]
fn main() -> ! {
    if let Some(core) = Peripherals::take() {
        begin_ticks(core.SYST);
        Serial::begin();
        _ = run();
    }
    SCB::sys_reset()
}

fn run() -> Result<Infallible, TooSmall> {
    let wire = Wire::new(Serial, [0; wire_len::<Tank>()]);
    let mut tank: Running = Recorder::over(Tank::new(), wire)?;
    let room = [Tank::STEPS[0]; Tank::STEPS.len()];
    let mut commands = Commands::<Tank, _, _>::new([0; command_len::<Tank>()], room, OLDEST);
    let (mut plant, mut mode, mut now) = (Plant::default(), Mode::Automatic, 0_u32);
    loop {
        cortex_m::asm::wfi();
        let (mut push, mut forced) = (false, None);
        // At most one command a cycle: the chart has seen it before the next one comes.
        while let Some(byte) = Serial::read() {
            let Some(command) = commands.push(byte, tank.cycles()) else { continue };
            let answer = command.map_or_else(
                |refused| refused,
                |command| carry_out(&command, &mut tank, &plant, now, (&mut mode, &mut push, &mut forced)),
            );
            tank.answer(answer);
            break;
        }
        let inputs = TankInputs { push, ..plant.inputs(mode) };
        // A forced cycle takes the place of the next one.
        let outputs = match forced {
            Some(outputs) => outputs,
            None => tank.cycle(&inputs, now, &mut ()),
        };
        plant.goes_on(&outputs);
        now = now.wrapping_add(CYCLE);
        if now % TELLS == 0 {
            tank.tell_state();
        }
    }
}

/// Does what a command wants, or says why not. What it changes: the mode, the push button, the outputs of a forced cycle.
fn carry_out(
    command: &Command<'_, TankStep>,
    tank: &mut Running,
    plant: &Plant,
    now: u32,
    (mode, push, forced): (&mut Mode, &mut bool, &mut Option<TankOutputs>),
) -> Answer {
    match command.wanted {
        Wanted::Init => tank.change(Tank::init),
        Wanted::Mode(new) => *mode = new,
        Wanted::Push => *push = true,
        // Nobody forces what runs by itself.
        Wanted::Force(_) if !matches!(mode, Mode::Manual | Mode::Paused) => return command.refused(Refused::NotNow),
        Wanted::Force(steps) => match tank.change(|tank| tank.force(steps, &plant.inputs(*mode), now)) {
            Ok(outputs) => *forced = Some(outputs),
            Err(error) => return command.not_forced(error),
        },
    }
    command.accepted()
}

/// The tank itself, which the board does not have: how full and how hot it is, in tenths of a per cent and of a degree.
#[derive(Default)]
struct Plant {
    level: u32,
    heat: u32,
}

impl Plant {
    fn inputs(&self, mode: Mode) -> TankInputs {
        TankInputs {
            full: self.level >= 900,
            hot: self.heat >= 600,
            empty: self.level < 50,
            semi_automatic: mode == Mode::SemiAutomatic,
            manual: mode == Mode::Manual,
            paused: mode == Mode::Paused,
            push: false,
        }
    }

    /// A cycle of 10 ms.
    fn goes_on(&mut self, outputs: &TankOutputs) {
        if outputs.inlet {
            self.level = (self.level + 9).min(1000);
        }
        if outputs.outlet {
            self.level = self.level.saturating_sub(12);
        }
        self.heat = if outputs.heater { (self.heat + 8).min(900) } else { self.heat.saturating_sub(2) };
    }
}

fn begin_ticks(mut clock: SYST) {
    clock.set_clock_source(SystClkSource::Core);
    clock.set_reload(TICKS - 1);
    clock.clear_current();
    clock.enable_counter();
    clock.enable_interrupt();
}

/// The loop has slept until now.
#[exception]
fn SysTick() {}

/// The first serial line of the board (a PL011). It takes a byte at any time: the emulator is never slow.
struct Serial;

impl Serial {
    const DATA: *mut u32 = 0x4000_c000 as *mut u32;
    const FLAGS: *const u32 = 0x4000_c018 as *const u32;
    const SHAPE: *mut u32 = 0x4000_c02c as *mut u32;
    const CONTROL: *mut u32 = 0x4000_c030 as *mut u32;
    /// Nothing has come.
    const EMPTY: u32 = 0x10;

    /// Eight bits, with queues of sixteen bytes; on, in both directions.
    #[allow(unsafe_code, reason = "registers of the serial line, which nothing else uses")]
    fn begin() {
        // SAFETY: see above.
        unsafe {
            Self::SHAPE.write_volatile(0x70);
            Self::CONTROL.write_volatile(0x301);
        }
    }

    /// The next byte that has come.
    #[allow(unsafe_code, reason = "as above")]
    fn read() -> Option<u8> {
        // SAFETY: as above.
        let word = unsafe {
            if Self::FLAGS.read_volatile() & Self::EMPTY != 0 {
                return None;
            }
            Self::DATA.read_volatile()
        };
        // Above the byte stand the errors of the line.
        u8::try_from(word & 0xff).ok()
    }
}

impl embedded_io::ErrorType for Serial {
    type Error = Infallible;
}

impl embedded_io::Write for Serial {
    #[allow(unsafe_code, reason = "as above")]
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        for byte in bytes {
            // SAFETY: as above.
            unsafe { Self::DATA.write_volatile(u32::from(*byte)) };
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// The board begins anew.
#[panic_handler]
fn panicked(_: &PanicInfo<'_>) -> ! {
    SCB::sys_reset()
}
