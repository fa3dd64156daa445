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
            edge0_before: true,
        }
    }
}
impl Crossing {
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &CrossingInputs,
        #[cfg(doc)]
        inputs: &CrossingInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> CrossingOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
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
        self.reading = now_;
        if self.first {
            self.since = now_;
        }
        let was_state_: __CrossingState = self.situation;
        let edge0_now_: bool = inputs_.button;
        let mut clears_cars_asked_: bool = false;
        let mut clears_asked_yellow_: bool = false;
        let mut clears_yellow_stop_: bool = false;
        let mut clears_stop_walk_: bool = false;
        let mut clears_walk_clear_: bool = false;
        let mut clears_clear_cars_: bool = false;
        let entered_cars_: bool;
        let mut entered_asked_: bool = false;
        let mut entered_yellow_: bool = false;
        let mut entered_stop_: bool = false;
        let mut entered_walk_: bool = false;
        let mut entered_clear_: bool = false;
        if self.first {
            entered_cars_ = true;
        } else {
            clears_cars_asked_ = was_state_ == __CrossingState::Cars
                && ({
                    let rising_0_ = !self.edge0_before && edge0_now_;
                    rising_0_
                });
            clears_asked_yellow_ = was_state_ == __CrossingState::Asked
                && ({
                    let elapsed_5000_1_ = was_state_ == __CrossingState::Asked
                        && now_.since(self.since)
                            >= Ticks::new(5000u32);
                    elapsed_5000_1_
                });
            clears_yellow_stop_ = was_state_ == __CrossingState::Yellow
                && ({
                    let elapsed_3000_2_ = was_state_ == __CrossingState::Yellow
                        && now_.since(self.since)
                            >= Ticks::new(3000u32);
                    elapsed_3000_2_
                });
            clears_stop_walk_ = was_state_ == __CrossingState::Stop
                && ({
                    let elapsed_2000_3_ = was_state_ == __CrossingState::Stop
                        && now_.since(self.since)
                            >= Ticks::new(2000u32);
                    elapsed_2000_3_
                });
            clears_walk_clear_ = was_state_ == __CrossingState::Walk
                && ({
                    let elapsed_8000_4_ = was_state_ == __CrossingState::Walk
                        && now_.since(self.since)
                            >= Ticks::new(8000u32);
                    elapsed_8000_4_
                });
            clears_clear_cars_ = was_state_ == __CrossingState::Clear
                && ({
                    let elapsed_4000_5_ = was_state_ == __CrossingState::Clear
                        && now_.since(self.since)
                            >= Ticks::new(4000u32);
                    elapsed_4000_5_
                });
            let left_cars_: bool = clears_cars_asked_;
            let left_asked_: bool = clears_asked_yellow_;
            let left_yellow_: bool = clears_yellow_stop_;
            let left_stop_: bool = clears_stop_walk_;
            let left_walk_: bool = clears_walk_clear_;
            let left_clear_: bool = clears_clear_cars_;
            entered_cars_ = clears_clear_cars_
                && !(was_state_ == __CrossingState::Cars && !left_cars_);
            entered_asked_ = clears_cars_asked_
                && !(was_state_ == __CrossingState::Asked && !left_asked_);
            entered_yellow_ = clears_asked_yellow_
                && !(was_state_ == __CrossingState::Yellow && !left_yellow_);
            entered_stop_ = clears_yellow_stop_
                && !(was_state_ == __CrossingState::Stop && !left_stop_);
            entered_walk_ = clears_stop_walk_
                && !(was_state_ == __CrossingState::Walk && !left_walk_);
            entered_clear_ = clears_walk_clear_
                && !(was_state_ == __CrossingState::Clear && !left_clear_);
            if left_cars_ {
                self.situation = __CrossingState::NONE;
            }
            if left_asked_ {
                self.situation = __CrossingState::NONE;
            }
            if left_yellow_ {
                self.situation = __CrossingState::NONE;
            }
            if left_stop_ {
                self.situation = __CrossingState::NONE;
            }
            if left_walk_ {
                self.situation = __CrossingState::NONE;
            }
            if left_clear_ {
                self.situation = __CrossingState::NONE;
            }
            if entered_cars_ {
                self.situation = __CrossingState::Cars;
            }
            if entered_asked_ {
                self.situation = __CrossingState::Asked;
            }
            if entered_yellow_ {
                self.situation = __CrossingState::Yellow;
            }
            if entered_stop_ {
                self.situation = __CrossingState::Stop;
            }
            if entered_walk_ {
                self.situation = __CrossingState::Walk;
            }
            if entered_clear_ {
                self.situation = __CrossingState::Clear;
            }
        }
        let reached_time_: Ticks = now_.since(self.since);
        if entered_cars_ || entered_asked_ || entered_yellow_ || entered_stop_
            || entered_walk_ || entered_clear_
        {
            self.since = now_;
        }
        let on_cars_0__: bool = self.situation
            == __CrossingState::Cars;
        let on_asked_1__: bool = self.situation
            == __CrossingState::Asked;
        let on_asked_2__: bool = self.situation
            == __CrossingState::Asked;
        let on_yellow_3__: bool = self.situation
            == __CrossingState::Yellow;
        let on_yellow_4__: bool = self.situation
            == __CrossingState::Yellow;
        let on_stop_5__: bool = self.situation
            == __CrossingState::Stop;
        let on_stop_6__: bool = self.situation
            == __CrossingState::Stop;
        let on_walk_7__: bool = self.situation
            == __CrossingState::Walk;
        let on_walk_8__: bool = self.situation
            == __CrossingState::Walk;
        let on_walk_9__: bool = self.situation
            == __CrossingState::Walk;
        let on_walk_10__: bool = self.situation
            == __CrossingState::Walk;
        let on_clear_11__: bool = self.situation
            == __CrossingState::Clear;
        let q_green_: bool = on_cars_0__ || on_asked_1__;
        let q_wait_: bool = on_asked_2__ || on_yellow_4__
            || on_stop_6__;
        let q_yellow_: bool = on_yellow_3__;
        let q_red_: bool = on_stop_5__ || on_walk_7__
            || on_clear_11__;
        let q_walk_: bool = on_walk_8__;
        let q_chirp_: bool = on_walk_9__
            && !(on_walk_9__
                && now_.since(self.since) >= Ticks::new(1000u32));
        let q_hurry_: bool = on_walk_10__
            && now_.since(self.since) >= Ticks::new(6000u32);
        self.green = q_green_;
        self.wait = q_wait_;
        self.yellow = q_yellow_;
        self.red = q_red_;
        self.walk = q_walk_;
        self.chirp = q_chirp_;
        self.hurry = q_hurry_;
        self.settled = !(self.first || clears_cars_asked_ || clears_asked_yellow_
            || clears_yellow_stop_ || clears_stop_walk_ || clears_walk_clear_
            || clears_clear_cars_);
        self.edge0_before = edge0_now_;
        self.first = false;
        outputs_.green = self.green;
        outputs_.yellow = self.yellow;
        outputs_.red = self.red;
        outputs_.wait = self.wait;
        outputs_.walk = self.walk;
        outputs_.chirp = self.chirp;
        outputs_.hurry = self.hurry;
        outputs_
    }
    pub fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if !self.settled {
            return Option::Some(self.reading);
        }
        let mut soonest_ = Option::None;
        if self.situation == __CrossingState::Asked
            && self.reading.since(self.since) < Ticks::new(5000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(5000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Yellow
            && self.reading.since(self.since) < Ticks::new(3000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(3000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Stop
            && self.reading.since(self.since) < Ticks::new(2000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(2000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(1000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(1000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(6000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(6000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(8000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(8000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Clear
            && self.reading.since(self.since) < Ticks::new(4000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(4000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.reading.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
