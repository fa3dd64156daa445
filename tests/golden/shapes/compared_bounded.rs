// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Fill {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &FillInputs) -> FillOutputs {
        let mut outputs = FillOutputs {
            valve: false,
            pump: false,
        };
        self.region_0 = self.region_0.unmarked();
        let mut evolutions_left: u32 = 14;
        loop {
            let inputs = core::hint::black_box(inputs);
            let before_0 = self.region_0.state();
            let before_1 = self.region_1;
            let mut after_0 = before_0;
            let mut after_1 = before_1;
            match before_0 {
                __FillRegion0::Wait => {
                    if inputs.stop {
                        after_0 = __FillRegion0::Stopped;
                    } else if {
                        let value = inputs.start && (!inputs.stop);
                        value
                    } {
                        after_0 = __FillRegion0::Valve;
                        after_1 = __FillRegion1::Pump;
                    } else {}
                }
                __FillRegion0::Valve => {
                    if inputs.stop {
                        after_0 = __FillRegion0::Stopped;
                    } else if {
                        let value = inputs.full && (!inputs.stop);
                        value
                    } {
                        after_0 = __FillRegion0::Open;
                    } else {}
                }
                __FillRegion0::Open => {
                    if inputs.stop {
                        after_0 = __FillRegion0::Stopped;
                    } else if (before_1 == __FillRegion1::Running)
                        && {
                            let stop = inputs.stop;
                            (true) && (!stop)
                        }
                    {
                        after_1 = __FillRegion1::NONE;
                        after_0 = __FillRegion0::Wait;
                    }
                }
                __FillRegion0::Stopped => {
                    if {
                        let stop = inputs.stop;
                        let active_0 = before_0 == __FillRegion0::Wait;
                        let active_1 = before_0 == __FillRegion0::Valve;
                        let active_2 = before_0 == __FillRegion0::Open;
                        let active_3 = before_1 == __FillRegion1::Pump;
                        let active_4 = before_1 == __FillRegion1::Running;
                        (!stop)
                            && (!(stop
                                && (active_0 || active_1
                                    || (active_2 || (active_3 || active_4)))))
                    } {
                        after_0 = __FillRegion0::Wait;
                    }
                }
            }
            match before_1 {
                __FillRegion1::Pump => {
                    if inputs.stop {
                        after_1 = __FillRegion1::NONE;
                        after_0 = __FillRegion0::Stopped;
                    } else if {
                        let value = inputs.full && (!inputs.stop);
                        value
                    } {
                        after_1 = __FillRegion1::Running;
                    } else {}
                }
                __FillRegion1::Running => {
                    if inputs.stop {
                        after_1 = __FillRegion1::NONE;
                        after_0 = __FillRegion0::Stopped;
                    }
                }
                _ => {}
            }
            if after_0 == before_0 && after_1 == before_1 {
                break;
            }
            if evolutions_left == 0 {
                self.region_0 = self.region_0.marked();
                break;
            }
            evolutions_left -= 1;
            self.region_0 = __FillRegion0Mark::of(after_0);
            self.region_1 = after_1;
        }
        let after_0 = self.region_0.state();
        let after_1 = self.region_1;
        match after_0 {
            __FillRegion0::Valve => {
                outputs.valve = true;
            }
            _ => {}
        }
        match after_1 {
            __FillRegion1::Pump => {
                outputs.pump = true;
            }
            _ => {}
        }
        outputs
    }
}
