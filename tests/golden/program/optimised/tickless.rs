// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Crossing {
    state: __CrossingState,
    reading: Ticks,
    settled: bool,
    time: Ticks,
    edge0_before: bool,
    l_tmr_chirp_held: Ticks,
    l_tmr_chirp_in: bool,
    d_tmr_hurry_held: Ticks,
    d_tmr_hurry_in: bool,
}
impl Crossing {
    pub const fn new() -> Self {
        Self {
            state: __CrossingState::INIT,
            reading: Ticks::ZERO,
            settled: false,
            time: Ticks::ZERO,
            edge0_before: false,
            l_tmr_chirp_held: Ticks::ZERO,
            l_tmr_chirp_in: false,
            d_tmr_hurry_held: Ticks::ZERO,
            d_tmr_hurry_in: false,
        }
    }
}
impl Crossing {
    pub fn cycle(
        &mut self,
        inputs: &CrossingInputs,
        now: impl core::convert::Into<Ticks>,
    ) -> CrossingOutputs {
        let now: Ticks = core::convert::Into::into(
            now,
        );
        let mut outputs = const {
            CrossingOutputs {
                green: false,
                yellow: false,
                red: false,
                wait: false,
                walk: false,
                chirp: false,
                hurry: false,
            }
        };
        let elapsed: Ticks = now.since(self.reading);
        self.reading = now;
        self.time = self.time + elapsed;
        match self.state {
            __CrossingState::INIT => {
                self.time = Ticks::ZERO;
                self.state = __CrossingState::Cars;
            }
            __CrossingState::Cars => {
                if !self.edge0_before && inputs.button {
                    self.state = __CrossingState::Asked;
                    self.time = Ticks::ZERO;
                    self.settled = false;
                } else {
                    self.settled = !(!self.edge0_before && inputs.button);
                }
            }
            __CrossingState::Asked => {
                if self.time >= Ticks::new(5000u32) {
                    self.state = __CrossingState::Yellow;
                    self.time = Ticks::ZERO;
                    self.settled = false;
                } else {
                    self.settled = !(!self.edge0_before && inputs.button);
                }
            }
            __CrossingState::Yellow => {
                if self.time >= Ticks::new(3000u32) {
                    self.state = __CrossingState::Stop;
                    self.time = Ticks::ZERO;
                    self.settled = false;
                } else {
                    self.settled = !(!self.edge0_before && inputs.button);
                }
            }
            __CrossingState::Stop => {
                if self.time >= Ticks::new(2000u32) {
                    self.state = __CrossingState::Walk;
                    self.time = Ticks::ZERO;
                    self.l_tmr_chirp_in = true;
                    self.d_tmr_hurry_in = true;
                    outputs.chirp = true;
                    self.settled = false;
                } else {
                    self.settled = !(!self.edge0_before && inputs.button);
                }
            }
            __CrossingState::Walk => {
                if self.time >= Ticks::new(8000u32) {
                    self.state = __CrossingState::Clear;
                    self.time = Ticks::ZERO;
                    self.l_tmr_chirp_held = Ticks::ZERO;
                    self.l_tmr_chirp_in = false;
                    self.d_tmr_hurry_held = Ticks::ZERO;
                    self.d_tmr_hurry_in = false;
                    self.settled = false;
                } else {
                    self.l_tmr_chirp_held = self.l_tmr_chirp_held + elapsed;
                    self.d_tmr_hurry_held = self.d_tmr_hurry_held + elapsed;
                    outputs.chirp = self.l_tmr_chirp_held
                        < Ticks::new(1000u32);
                    outputs.hurry = self.d_tmr_hurry_held
                        >= Ticks::new(6000u32);
                    self.settled = !(!self.edge0_before && inputs.button);
                }
            }
            __CrossingState::Clear => {
                if self.time >= Ticks::new(4000u32) {
                    self.state = __CrossingState::Cars;
                    self.time = Ticks::ZERO;
                    self.settled = false;
                } else {
                    self.settled = !(!self.edge0_before && inputs.button);
                }
            }
        }
        match self.state {
            __CrossingState::Cars => {
                outputs.green = true;
            }
            __CrossingState::Asked => {
                outputs.green = true;
                outputs.wait = true;
            }
            __CrossingState::Yellow => {
                outputs.wait = true;
                outputs.yellow = true;
            }
            __CrossingState::Stop => {
                outputs.wait = true;
                outputs.red = true;
            }
            __CrossingState::Walk => {
                outputs.red = true;
                outputs.walk = true;
            }
            __CrossingState::Clear => {
                outputs.red = true;
            }
            _ => {}
        }
        self.edge0_before = inputs.button;
        outputs
    }
    pub fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if !self.settled {
            return Option::Some(self.reading);
        }
        let mut soonest = Option::None;
        if self.state == __CrossingState::Asked
            && self.time < Ticks::new(5000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(5000u32) - self.time,
                ),
            );
        }
        if self.state == __CrossingState::Yellow
            && self.time < Ticks::new(3000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(3000u32) - self.time,
                ),
            );
        }
        if self.state == __CrossingState::Stop
            && self.time < Ticks::new(2000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(2000u32) - self.time,
                ),
            );
        }
        if self.state == __CrossingState::Walk
            && self.time < Ticks::new(8000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(8000u32) - self.time,
                ),
            );
        }
        if self.state == __CrossingState::Clear
            && self.time < Ticks::new(4000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(4000u32) - self.time,
                ),
            );
        }
        if self.l_tmr_chirp_in
            && self.l_tmr_chirp_held < Ticks::new(1000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(1000u32) - self.l_tmr_chirp_held,
                ),
            );
        }
        if self.d_tmr_hurry_in
            && self.d_tmr_hurry_held < Ticks::new(6000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(6000u32) - self.d_tmr_hurry_held,
                ),
            );
        }
        match soonest {
            Option::Some(time) => {
                Option::Some(self.reading.after(time))
            }
            Option::None => Option::None,
        }
    }
}
