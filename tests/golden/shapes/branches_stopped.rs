// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __MixerRegion0 {
    Idle,
    Fill,
    Mix,
    Empty,
    Stopped,
}
enum __MixerRegion1 {
    Weigh,
    Weighed,
    NONE,
}
impl Mixer {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &MixerInputs,
        #[cfg(doc)]
        inputs: &MixerInputs,
    ) -> MixerOutputs {
        let mut outputs_ = const {
            MixerOutputs {
                valve: false,
                motor: false,
                screw: false,
                alarm: false,
            }
        };
        let inputs_ = core::hint::black_box(inputs_);
        loop {
            fence_on_armv6m();
            let mut moves_27__: bool = false;
            let was_state_idle_: __MixerRegion0 = self.region_0;
            if inputs_.stop {
                if self.region_0 != __MixerRegion0::Stopped {
                    moves_27__ = true;
                    self.region_1 = __MixerRegion1::NONE;
                    self.region_0 = __MixerRegion0::Stopped;
                }
            } else {
                match self.region_0 {
                    __MixerRegion0::Idle => {
                        if inputs_.start {
                            self.region_0 = __MixerRegion0::Fill;
                            self.region_1 = __MixerRegion1::Weigh;
                            moves_27__ = true;
                        }
                    }
                    __MixerRegion0::Empty => {
                        if !inputs_.full {
                            self.region_0 = __MixerRegion0::Idle;
                            moves_27__ = true;
                        }
                    }
                    __MixerRegion0::Stopped => {
                        if inputs_.ack {
                            self.region_0 = __MixerRegion0::Idle;
                            moves_27__ = true;
                        }
                    }
                    _ => {
                        if self.region_0 == __MixerRegion0::Mix
                            && self.region_1 == __MixerRegion1::Weighed && inputs_.mixed
                        {
                            moves_27__ = true;
                            self.region_1 = __MixerRegion1::NONE;
                            self.region_0 = __MixerRegion0::Empty;
                        } else {
                            match self.region_0 {
                                __MixerRegion0::Fill => {
                                    if inputs_.full {
                                        self.region_0 = __MixerRegion0::Mix;
                                        moves_27__ = true;
                                    }
                                }
                                _ => {}
                            }
                            core::sync::atomic::compiler_fence(
                                core::sync::atomic::Ordering::SeqCst,
                            );
                            match self.region_1 {
                                __MixerRegion1::Weigh => {
                                    if inputs_.weighed {
                                        self.region_1 = __MixerRegion1::Weighed;
                                        moves_27__ = true;
                                    }
                                }
                                _ => {}
                            }
                        }
                    }
                }
            }
            if !moves_27__ {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_0 {
            __MixerRegion0::Fill => {
                outputs_.valve = true;
            }
            __MixerRegion0::Mix => {
                outputs_.motor = true;
            }
            __MixerRegion0::Stopped => {
                outputs_.alarm = true;
            }
            _ => {}
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_1 {
            __MixerRegion1::Weigh => {
                outputs_.screw = true;
            }
            _ => {}
        }
        outputs_
    }
}
