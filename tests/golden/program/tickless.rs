// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Crossing {
    first: bool,
    situation: __CrossingState,
    green: bool,
    yellow: bool,
    red: bool,
    wait: bool,
    walk: bool,
    chirp: bool,
    hurry: bool,
    reading: Ticks,
    settled: bool,
    since: Ticks,
    edge0_before: bool,
}
impl Crossing {
    pub const fn new() -> Self {
        Self {
            first: true,
            situation: __CrossingState::Cars,
            green: false,
            yellow: false,
            red: false,
            wait: false,
            walk: false,
            chirp: false,
            hurry: false,
            reading: Ticks::ZERO,
            settled: false,
            since: Ticks::ZERO,
            edge0_before: false,
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
        self.reading = now;
        if self.first {
            self.since = now;
        }
        let was_state: __CrossingState = self.situation;
        let edge0_now: bool = inputs.button;
        if self.first {
            self.edge0_before = edge0_now;
        }
        let mut clears_cars_asked: bool = false;
        let mut clears_asked_yellow: bool = false;
        let mut clears_yellow_stop: bool = false;
        let mut clears_stop_walk: bool = false;
        let mut clears_walk_clear: bool = false;
        let mut clears_clear_cars: bool = false;
        let entered_cars: bool;
        let mut entered_asked: bool = false;
        let mut entered_yellow: bool = false;
        let mut entered_stop: bool = false;
        let mut entered_walk: bool = false;
        let mut entered_clear: bool = false;
        if self.first {
            entered_cars = true;
        } else {
            clears_cars_asked = was_state == __CrossingState::Cars
                && ({
                    let rising_0 = !self.edge0_before && edge0_now;
                    rising_0
                });
            clears_asked_yellow = was_state == __CrossingState::Asked
                && ({
                    let elapsed_5000_1 = was_state == __CrossingState::Asked
                        && now.since(self.since)
                            >= Ticks::new(5000u32);
                    elapsed_5000_1
                });
            clears_yellow_stop = was_state == __CrossingState::Yellow
                && ({
                    let elapsed_3000_2 = was_state == __CrossingState::Yellow
                        && now.since(self.since)
                            >= Ticks::new(3000u32);
                    elapsed_3000_2
                });
            clears_stop_walk = was_state == __CrossingState::Stop
                && ({
                    let elapsed_2000_3 = was_state == __CrossingState::Stop
                        && now.since(self.since)
                            >= Ticks::new(2000u32);
                    elapsed_2000_3
                });
            clears_walk_clear = was_state == __CrossingState::Walk
                && ({
                    let elapsed_8000_4 = was_state == __CrossingState::Walk
                        && now.since(self.since)
                            >= Ticks::new(8000u32);
                    elapsed_8000_4
                });
            clears_clear_cars = was_state == __CrossingState::Clear
                && ({
                    let elapsed_4000_5 = was_state == __CrossingState::Clear
                        && now.since(self.since)
                            >= Ticks::new(4000u32);
                    elapsed_4000_5
                });
            let left_cars: bool = clears_cars_asked;
            let left_asked: bool = clears_asked_yellow;
            let left_yellow: bool = clears_yellow_stop;
            let left_stop: bool = clears_stop_walk;
            let left_walk: bool = clears_walk_clear;
            let left_clear: bool = clears_clear_cars;
            entered_cars = clears_clear_cars
                && !(was_state == __CrossingState::Cars && !left_cars);
            entered_asked = clears_cars_asked
                && !(was_state == __CrossingState::Asked && !left_asked);
            entered_yellow = clears_asked_yellow
                && !(was_state == __CrossingState::Yellow && !left_yellow);
            entered_stop = clears_yellow_stop
                && !(was_state == __CrossingState::Stop && !left_stop);
            entered_walk = clears_stop_walk
                && !(was_state == __CrossingState::Walk && !left_walk);
            entered_clear = clears_walk_clear
                && !(was_state == __CrossingState::Clear && !left_clear);
            if left_cars {
                self.situation = __CrossingState::NONE;
            }
            if left_asked {
                self.situation = __CrossingState::NONE;
            }
            if left_yellow {
                self.situation = __CrossingState::NONE;
            }
            if left_stop {
                self.situation = __CrossingState::NONE;
            }
            if left_walk {
                self.situation = __CrossingState::NONE;
            }
            if left_clear {
                self.situation = __CrossingState::NONE;
            }
            if entered_cars {
                self.situation = __CrossingState::Cars;
            }
            if entered_asked {
                self.situation = __CrossingState::Asked;
            }
            if entered_yellow {
                self.situation = __CrossingState::Yellow;
            }
            if entered_stop {
                self.situation = __CrossingState::Stop;
            }
            if entered_walk {
                self.situation = __CrossingState::Walk;
            }
            if entered_clear {
                self.situation = __CrossingState::Clear;
            }
        }
        let reached_time: Ticks = now.since(self.since);
        if entered_cars || entered_asked || entered_yellow || entered_stop
            || entered_walk || entered_clear
        {
            self.since = now;
        }
        let on_cars_0_: bool = self.situation
            == __CrossingState::Cars;
        let on_asked_1_: bool = self.situation
            == __CrossingState::Asked;
        let on_asked_2_: bool = self.situation
            == __CrossingState::Asked;
        let on_yellow_3_: bool = self.situation
            == __CrossingState::Yellow;
        let on_yellow_4_: bool = self.situation
            == __CrossingState::Yellow;
        let on_stop_5_: bool = self.situation
            == __CrossingState::Stop;
        let on_stop_6_: bool = self.situation
            == __CrossingState::Stop;
        let on_walk_7_: bool = self.situation
            == __CrossingState::Walk;
        let on_walk_8_: bool = self.situation
            == __CrossingState::Walk;
        let on_walk_9_: bool = self.situation
            == __CrossingState::Walk;
        let on_walk_10_: bool = self.situation
            == __CrossingState::Walk;
        let on_clear_11_: bool = self.situation
            == __CrossingState::Clear;
        let q_green: bool = on_cars_0_ || on_asked_1_;
        let q_wait: bool = on_asked_2_ || on_yellow_4_
            || on_stop_6_;
        let q_yellow: bool = on_yellow_3_;
        let q_red: bool = on_stop_5_ || on_walk_7_ || on_clear_11_;
        let q_walk: bool = on_walk_8_;
        let q_chirp: bool = on_walk_9_
            && !(on_walk_9_
                && now.since(self.since) >= Ticks::new(1000u32));
        let q_hurry: bool = on_walk_10_
            && now.since(self.since) >= Ticks::new(6000u32);
        self.green = q_green;
        self.wait = q_wait;
        self.yellow = q_yellow;
        self.red = q_red;
        self.walk = q_walk;
        self.chirp = q_chirp;
        self.hurry = q_hurry;
        self.settled = !(self.first || clears_cars_asked || clears_asked_yellow
            || clears_yellow_stop || clears_stop_walk || clears_walk_clear
            || clears_clear_cars);
        self.edge0_before = edge0_now;
        self.first = false;
        outputs.green = self.green;
        outputs.yellow = self.yellow;
        outputs.red = self.red;
        outputs.wait = self.wait;
        outputs.walk = self.walk;
        outputs.chirp = self.chirp;
        outputs.hurry = self.hurry;
        outputs
    }
    pub fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if !self.settled {
            return Option::Some(self.reading);
        }
        let mut soonest = Option::None;
        if self.situation == __CrossingState::Asked
            && self.reading.since(self.since) < Ticks::new(5000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(5000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Yellow
            && self.reading.since(self.since) < Ticks::new(3000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(3000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Stop
            && self.reading.since(self.since) < Ticks::new(2000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(2000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(1000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(1000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(6000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(6000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(8000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(8000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Clear
            && self.reading.since(self.since) < Ticks::new(4000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(4000u32)
                        - self.reading.since(self.since),
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
