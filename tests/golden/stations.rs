// Recorded by `cargo xtask bless`.

/// Two stations beside each other, and a bit for each step.
#[cfg_attr(
    doc,
    doc = "\n\n<div style=\"overflow-x:auto\"><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4.5 -4.5 440 536\" style=\"width:440px;max-width:max(100%,264px);height:auto\" role=\"img\" aria-label=\"Chart Stations\"><g fill=\"none\" stroke=\"currentColor\"><path d=\"M12 8H76M108 184H124M348 184H364M100 440H116M12 520H76M68 134H324M68 138H324M68 358H324M68 362H324M12 8V520M76 8V40M76 72V134M76 138V168M76 200V296M76 328V358M76 362V424M76 456V520M148 424V456M156 168V200M316 138V168M316 200V296M316 328V358M76 96v16M76 256v16M316 256v16M76 384v16M76 480v16\"/><rect x=\"44\" y=\"40\" width=\"64\" height=\"32\"/><rect x=\"47\" y=\"43\" width=\"58\" height=\"26\"/><rect x=\"44\" y=\"168\" width=\"64\" height=\"32\"/><rect x=\"124\" y=\"168\" width=\"136\" height=\"32\"/><rect x=\"124\" y=\"200\" width=\"136\" height=\"32\"/><rect x=\"284\" y=\"168\" width=\"64\" height=\"32\"/><rect x=\"364\" y=\"168\" width=\"56\" height=\"32\"/><rect x=\"36\" y=\"296\" width=\"80\" height=\"32\"/><rect x=\"276\" y=\"296\" width=\"80\" height=\"32\"/><rect x=\"52\" y=\"424\" width=\"48\" height=\"32\"/><rect x=\"116\" y=\"424\" width=\"136\" height=\"32\"/><path d=\"M62 104h28M62 264h28M302 264h28M62 392h28M62 488h28\" stroke-width=\"3\"/></g><g fill=\"currentColor\" font-family=\"monospace\" font-size=\"13\" dominant-baseline=\"central\"><path d=\"M12 259l4 9h-8z\"/><text x=\"60\" y=\"56\" textLength=\"32\">Wait</text><text x=\"104\" y=\"104\" textLength=\"32\">part</text><text x=\"56\" y=\"184\" textLength=\"40\">Drill</text><text x=\"136\" y=\"184\" textLength=\"8\">↑</text><text x=\"168\" y=\"184\" textLength=\"80\">motor := 1</text><text x=\"136\" y=\"216\" textLength=\"40\">drill</text><text x=\"300\" y=\"184\" textLength=\"32\">Test</text><text x=\"376\" y=\"184\" textLength=\"32\">test</text><text x=\"104\" y=\"264\" textLength=\"56\">drilled</text><text x=\"344\" y=\"264\" textLength=\"48\">tested</text><text x=\"48\" y=\"312\" textLength=\"56\">Drilled</text><text x=\"292\" y=\"312\" textLength=\"48\">Tested</text><text x=\"104\" y=\"392\" textLength=\"40\">!part</text><text x=\"64\" y=\"440\" textLength=\"24\">Out</text><text x=\"128\" y=\"440\" textLength=\"8\">↑</text><text x=\"160\" y=\"440\" textLength=\"80\">motor := 0</text><text x=\"104\" y=\"488\" textLength=\"48\">2s/Out</text></g></svg></div>\n"
)]
/**

The situation takes one byte (`encoding flags;`): a bit for each of its 6 steps and one for the first cycle, as long as it is still to come.*/
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct Stations {
    situation: [::grafcet::__private::u8; 1usize],
    motor: ::grafcet::__private::core::primitive::bool,
    since_wait: ::grafcet::__private::Ticks,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for Stations {}
impl Stations {
    ///A chart `Stations` in its initial situation; its activation belongs to the first cycle.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            situation: [65u8],
            motor: false,
            since_wait: ::grafcet::__private::Ticks::ZERO,
        }
    }
}
impl ::grafcet::__private::core::default::Default for Stations {
    fn default() -> Self {
        Self::new()
    }
}
///The process inputs of [`Stations`], sampled once per cycle.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::default::Default
)]
pub struct StationsInputs {
    ///Input `part`.
    pub part: ::grafcet::__private::core::primitive::bool,
    ///Input `drilled`.
    pub drilled: ::grafcet::__private::core::primitive::bool,
    ///Input `tested`.
    pub tested: ::grafcet::__private::core::primitive::bool,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for StationsInputs {}
impl StationsInputs {
    /// The default inputs, for constants and statics.
    pub const DEFAULT: Self = Self {
        part: false,
        drilled: false,
        tested: false,
    };
}
///The process outputs of [`Stations`]; `default()` holds the initial values.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::default::Default
)]
pub struct StationsOutputs {
    ///Output `drill`.
    pub drill: ::grafcet::__private::core::primitive::bool,
    ///Output `test`.
    pub test: ::grafcet::__private::core::primitive::bool,
    ///Output `motor`.
    pub motor: ::grafcet::__private::core::primitive::bool,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for StationsOutputs {}
///The names of the steps of [`Stations`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash
)]
pub enum StationsStep {
    ///Step `Wait`.
    Wait,
    ///Step `Drill`.
    Drill,
    ///Step `Drilled`.
    Drilled,
    ///Step `Test`.
    Test,
    ///Step `Tested`.
    Tested,
    ///Step `Out`.
    Out,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for StationsStep {}
impl StationsStep {
    /// The name as it is written.
    #[must_use]
    pub const fn name(self) -> &'static ::grafcet::__private::str {
        ::grafcet::__private::name_at(
            &["Wait", "Drill", "Drilled", "Test", "Tested", "Out"],
            self as ::grafcet::__private::usize,
        )
    }
}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for StationsStep {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str((*self).name())
    }
}
impl ::grafcet::__private::core::fmt::Display for StationsStep {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.pad((*self).name())
    }
}
///The names of the transitions of [`Stations`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash
)]
pub enum StationsTransition {
    ///`Wait -[part]-> (Drill, Test)`
    WaitToDrillAndTest,
    ///`Drill -[drilled]-> Drilled`
    DrillToDrilled,
    ///`Test -[tested]-> Tested`
    TestToTested,
    ///`(Drilled, Tested) -[!part]-> Out`
    DrilledAndTestedToOut,
    ///`Out -[2s/Out]-> Wait`
    OutToWait,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for StationsTransition {}
impl StationsTransition {
    /// The name as it is written.
    #[must_use]
    pub const fn name(self) -> &'static ::grafcet::__private::str {
        ::grafcet::__private::name_at(
            &[
                "WaitToDrillAndTest",
                "DrillToDrilled",
                "TestToTested",
                "DrilledAndTestedToOut",
                "OutToWait",
            ],
            self as ::grafcet::__private::usize,
        )
    }
}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for StationsTransition {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str((*self).name())
    }
}
impl ::grafcet::__private::core::fmt::Display for StationsTransition {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.pad((*self).name())
    }
}
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq
)]
#[doc(hidden)]
enum __StationsRegion0 {
    Wait,
    Drill,
    Drilled,
    Out,
    INIT,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for __StationsRegion0 {}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for __StationsRegion0 {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str(
            ::grafcet::__private::name_at(
                &["Wait", "Drill", "Drilled", "Out", "INIT"],
                *self as ::grafcet::__private::usize,
            ),
        )
    }
}
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq
)]
#[doc(hidden)]
enum __StationsRegion1 {
    Test,
    Tested,
    NONE,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for __StationsRegion1 {}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for __StationsRegion1 {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str(
            ::grafcet::__private::name_at(
                &["Test", "Tested", "NONE"],
                *self as ::grafcet::__private::usize,
            ),
        )
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl Stations {
    const fn region_0_(&self) -> __StationsRegion0 {
        if self.situation[0usize] & 64u8 != 0 {
            return __StationsRegion0::INIT;
        }
        match self.situation[0usize] & 7u8 {
            1u8 => __StationsRegion0::Wait,
            2u8 => __StationsRegion0::Drill,
            4u8 => __StationsRegion0::Drilled,
            _ => __StationsRegion0::Out,
        }
    }
    const fn region_1_(&self) -> __StationsRegion1 {
        match self.situation[0usize] & 24u8 {
            8u8 => __StationsRegion1::Test,
            16u8 => __StationsRegion1::Tested,
            _ => __StationsRegion1::NONE,
        }
    }
}
///A situation of [`Stations`]: which steps are active.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct StationsSituation {
    steps: [::grafcet::__private::u8; 1usize],
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for StationsSituation {}
impl StationsSituation {
    /// Whether the step is active in this situation.
    #[must_use]
    pub fn is_active(
        &self,
        #[cfg(not(doc))]
        step_: StationsStep,
        #[cfg(doc)]
        step: StationsStep,
    ) -> ::grafcet::__private::bool {
        match step_ {
            StationsStep::Wait => self.steps[0usize] & 1u8 != 0,
            StationsStep::Drill => self.steps[0usize] & 2u8 != 0,
            StationsStep::Drilled => self.steps[0usize] & 4u8 != 0,
            StationsStep::Test => self.steps[0usize] & 8u8 != 0,
            StationsStep::Tested => self.steps[0usize] & 16u8 != 0,
            StationsStep::Out => self.steps[0usize] & 32u8 != 0,
        }
    }
}
impl ::grafcet::__private::core::fmt::Debug for StationsSituation {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        let mut set_ = f_.debug_set();
        for step_ in <Stations as ::grafcet::__private::Chart>::STEPS {
            if self.is_active(*step_) {
                let _ = ::grafcet::__private::core::fmt::DebugSet::entry(
                    &mut set_,
                    step_,
                );
            }
        }
        ::grafcet::__private::core::fmt::DebugSet::finish(&mut set_)
    }
}
/// The names of the active steps, as in `Fill, Heat`; nothing where none is active.
impl ::grafcet::__private::core::fmt::Display for StationsSituation {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        let names_ = ::grafcet::__private::core::iter::Iterator::map(
            <Stations as ::grafcet::__private::Chart>::STEPS.iter(),
            |step_| (*step_).name(),
        );
        ::grafcet::__private::situation::write(self, names_, f_)
    }
}
impl Stations {
    #[allow(unused_assignments)]
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &StationsInputs,
        #[cfg(doc)]
        inputs: &StationsInputs,
        #[cfg(not(doc))]
        now_: impl ::grafcet::__private::core::convert::Into<
            ::grafcet::__private::Ticks,
        >,
        #[cfg(doc)]
        now: impl ::grafcet::__private::core::convert::Into<::grafcet::__private::Ticks>,
    ) -> StationsOutputs {
        let now_: ::grafcet::__private::Ticks = ::grafcet::__private::core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            StationsOutputs {
                drill: false,
                test: false,
                motor: false,
            }
        };
        let before_0_ = Self::region_0_(self);
        let mut region_0_ = before_0_;
        if before_0_ == __StationsRegion0::INIT {
            self.situation = [1u8];
        }
        let before_1_ = Self::region_1_(self);
        let mut region_1_ = before_1_;
        let first_: ::grafcet::__private::bool = region_0_ == __StationsRegion0::INIT;
        if first_ {
            region_0_ = __StationsRegion0::Wait;
        }
        let inputs_ = ::grafcet::__private::core::hint::black_box(inputs_);
        loop {
            let mut moves_21__: ::grafcet::__private::bool = false;
            match region_0_ {
                __StationsRegion0::Wait => {
                    if inputs_.part {
                        region_0_ = __StationsRegion0::Drill;
                        region_1_ = __StationsRegion1::Test;
                        moves_21__ = true;
                        self.motor = true;
                    }
                }
                __StationsRegion0::Out => {
                    if ::grafcet::__private::has_reached!(
                        now_.since(self.since_wait),
                        ::grafcet::__private::Ticks::new(2000u32)
                    ) {
                        region_0_ = __StationsRegion0::Wait;
                        moves_21__ = true;
                    }
                }
                _ => {
                    if region_0_ == __StationsRegion0::Drilled
                        && region_1_ == __StationsRegion1::Tested && !inputs_.part
                    {
                        moves_21__ = true;
                        self.motor = false;
                        self.since_wait = now_;
                        region_1_ = __StationsRegion1::NONE;
                        region_0_ = __StationsRegion0::Out;
                    } else {
                        match region_0_ {
                            __StationsRegion0::Drill => {
                                if inputs_.drilled {
                                    region_0_ = __StationsRegion0::Drilled;
                                    moves_21__ = true;
                                }
                            }
                            _ => {}
                        }
                        ::grafcet::__private::core::sync::atomic::compiler_fence(
                            ::grafcet::__private::core::sync::atomic::Ordering::SeqCst,
                        );
                        match region_1_ {
                            __StationsRegion1::Test => {
                                if inputs_.tested {
                                    region_1_ = __StationsRegion1::Tested;
                                    moves_21__ = true;
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
            if !moves_21__ {
                break;
            }
        }
        ::grafcet::__private::core::sync::atomic::compiler_fence(
            ::grafcet::__private::core::sync::atomic::Ordering::SeqCst,
        );
        match region_0_ {
            __StationsRegion0::Drill => {
                outputs_.drill = true;
            }
            _ => {}
        }
        ::grafcet::__private::core::sync::atomic::compiler_fence(
            ::grafcet::__private::core::sync::atomic::Ordering::SeqCst,
        );
        match region_1_ {
            __StationsRegion1::Test => {
                outputs_.test = true;
            }
            _ => {}
        }
        if region_0_ != before_0_ {
            self.situation[0usize] = self.situation[0usize] & 216u8
                | match region_0_ {
                    __StationsRegion0::Wait => 1u8,
                    __StationsRegion0::Drill => 2u8,
                    __StationsRegion0::Drilled => 4u8,
                    __StationsRegion0::Out => 32u8,
                    _ => 0u8,
                };
        }
        if region_1_ != before_1_ {
            self.situation[0usize] = self.situation[0usize] & 231u8
                | match region_1_ {
                    __StationsRegion1::Test => 8u8,
                    __StationsRegion1::Tested => 16u8,
                    _ => 0u8,
                };
        }
        outputs_.motor = self.motor;
        outputs_
    }
    /// Back to the initial situation (the classic *Init*), stored outputs and variables reset; the next cycle is a
    /// first one.
    pub fn init(&mut self) {
        *self = Self::new();
    }
    /// Whether the step is active.
    #[must_use]
    pub fn is_active(
        &self,
        #[cfg(not(doc))]
        step_: StationsStep,
        #[cfg(doc)]
        step: StationsStep,
    ) -> ::grafcet::__private::bool {
        match step_ {
            StationsStep::Wait => {
                self.situation[0usize] & 1u8 != 0 || self.situation[0usize] & 64u8 != 0
            }
            StationsStep::Drill => self.situation[0usize] & 2u8 != 0,
            StationsStep::Drilled => self.situation[0usize] & 4u8 != 0,
            StationsStep::Test => self.situation[0usize] & 8u8 != 0,
            StationsStep::Tested => self.situation[0usize] & 16u8 != 0,
            StationsStep::Out => self.situation[0usize] & 32u8 != 0,
        }
    }
    /// The active steps, in the order of their declaration; the capacity is the most that can be active.
    #[must_use]
    pub fn active_steps(&self) -> ::grafcet::__private::heapless::Vec<StationsStep, 2> {
        let mut steps_ = ::grafcet::__private::heapless::Vec::new();
        if self.situation[0usize] & 1u8 != 0 || self.situation[0usize] & 64u8 != 0 {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                StationsStep::Wait,
            );
        }
        if self.situation[0usize] & 2u8 != 0 {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                StationsStep::Drill,
            );
        }
        if self.situation[0usize] & 4u8 != 0 {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                StationsStep::Drilled,
            );
        }
        if self.situation[0usize] & 8u8 != 0 {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                StationsStep::Test,
            );
        }
        if self.situation[0usize] & 16u8 != 0 {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                StationsStep::Tested,
            );
        }
        if self.situation[0usize] & 32u8 != 0 {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                StationsStep::Out,
            );
        }
        steps_
    }
    /// The situation: which steps are active.
    #[must_use]
    pub const fn situation(&self) -> StationsSituation {
        let mut steps_ = self.situation;
        steps_[0usize] &= !64u8;
        StationsSituation { steps: steps_ }
    }
    /// Whether these steps are active, in any order, and no others: the same question for one active step and
    /// for several.
    #[must_use]
    pub fn is_exactly(
        &self,
        #[cfg(not(doc))]
        steps_: &[StationsStep],
        #[cfg(doc)]
        steps: &[StationsStep],
    ) -> ::grafcet::__private::bool {
        ::grafcet::__private::Chart::is_exactly(self, steps_)
    }
    /// Whether the last cycle reached a stable situation. If not, it stopped after the most evolutions it may make
    /// and keeps the situation it had reached (decision A30).
    #[must_use]
    pub const fn is_stable(&self) -> ::grafcet::__private::bool {
        true
    }
    /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
    /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
    /// "scan again at once"; `None` means "only an input can change anything".
    #[must_use]
    pub fn next_deadline(
        &self,
    ) -> ::grafcet::__private::Option<::grafcet::__private::Ticks> {
        if !!(Self::region_0_(self) == __StationsRegion0::INIT) {
            return ::grafcet::__private::Option::Some(self.since_wait);
        }
        let mut soonest_ = ::grafcet::__private::Option::None;
        if Self::region_0_(self) == __StationsRegion0::Out {
            soonest_ = ::grafcet::__private::sooner(
                soonest_,
                ::grafcet::__private::Option::Some(
                    ::grafcet::__private::Ticks::new(2000u32),
                ),
            );
        }
        match soonest_ {
            ::grafcet::__private::Option::Some(time_) => {
                ::grafcet::__private::Option::Some(self.since_wait.after(time_))
            }
            ::grafcet::__private::Option::None => ::grafcet::__private::Option::None,
        }
    }
    /// A duration in the chart's clock unit, rounded up.
    #[must_use]
    pub const fn ticks(
        #[cfg(not(doc))]
        duration_: ::grafcet::__private::core::time::Duration,
        #[cfg(doc)]
        duration: ::grafcet::__private::core::time::Duration,
    ) -> ::grafcet::__private::Ticks {
        #[cfg(doc)]
        let duration_ = duration;
        ::grafcet::__private::Ticks::from_duration(duration_, 1000000)
    }
}
impl ::grafcet::__private::Chart for Stations {
    type Inputs = StationsInputs;
    type Outputs = StationsOutputs;
    type Step = StationsStep;
    type Transition = StationsTransition;
    type Situation = StationsSituation;
    type Actions<'a> = ();
    const NAME: &'static ::grafcet::__private::str = "Stations";
    const STEPS: &'static [StationsStep] = &[
        StationsStep::Wait,
        StationsStep::Drill,
        StationsStep::Drilled,
        StationsStep::Test,
        StationsStep::Tested,
        StationsStep::Out,
    ];
    const TRANSITIONS: &'static [StationsTransition] = &[
        StationsTransition::WaitToDrillAndTest,
        StationsTransition::DrillToDrilled,
        StationsTransition::TestToTested,
        StationsTransition::DrilledAndTestedToOut,
        StationsTransition::OutToWait,
    ];
    fn scan(
        &mut self,
        inputs_: &StationsInputs,
        now_: ::grafcet::__private::Ticks,
        _: &mut Self::Actions<'_>,
    ) -> StationsOutputs {
        self.cycle(inputs_, now_)
    }
    fn init(&mut self) {
        self.init();
    }
    fn is_active(&self, step_: StationsStep) -> ::grafcet::__private::bool {
        self.is_active(step_)
    }
    fn situation(&self) -> StationsSituation {
        self.situation()
    }
}
impl Stations {
    /// What the chart looks like: its steps, transitions and actions as they stand in the source.
    pub const CHART: ::grafcet::__private::description::Description<'static> = ::grafcet::__private::description::table::Described::<
        Stations,
        4,
        0,
        12,
        1,
        0,
        6,
        5,
        0,
    >::grafcet();
}
impl ::grafcet::__private::description::table::Tables for Stations {
    const TEXTS: &'static [&'static ::grafcet::__private::str] = &[
        "",
        "!part",
        "2s/Out",
        "Drill",
        "Drilled",
        "N",
        "Out",
        "R",
        "S",
        "Stations",
        "Test",
        "Tested",
        "Wait",
        "drill",
        "drilled",
        "motor",
        "part",
        "test",
        "tested",
    ];
    const NUMBERS: &'static [::grafcet::__private::u8] = b"\x08\0\0\x0F\x05\0\0\r\x05\0\0\x11\x07\0\0\x0F\0\x01\x03\x01\x02\x03\x04\x02\x04\x05\x05\0\t\0\0\0\x0C\x01\0\0\0\0\0\x03\0\0\0\x02\0\0\x04\0\0\0\0\0\0\n\0\0\0\x01\0\0\x0B\0\0\0\0\0\0\x06\0\0\0\x01\0\0\0\x10\x01\x02\0\0\0\x0E\x01\x01\0\0\0\x12\x01\x01\0\0\0\x01\x02\x01\0\0\0\x02\x01\x01\0\0";
}
impl ::grafcet::__private::ActiveSteps for StationsSituation {
    fn is_active_at(
        &self,
        step_: ::grafcet::__private::usize,
    ) -> ::grafcet::__private::bool {
        match ::grafcet::__private::step_at::<Stations>(step_) {
            ::grafcet::__private::Option::Some(active_) => self.is_active(active_),
            ::grafcet::__private::Option::None => false,
        }
    }
}
#[allow(unexpected_cfgs)]
const _: () = {
    #[cfg(rust_analyzer)]
    fn mentions(inputs_: &StationsInputs, outputs_: &StationsOutputs) {
        let _ = [
            StationsStep::Wait,
            StationsStep::Drill,
            StationsStep::Test,
            StationsStep::Drill,
            StationsStep::Drilled,
            StationsStep::Test,
            StationsStep::Tested,
            StationsStep::Drilled,
            StationsStep::Tested,
            StationsStep::Out,
            StationsStep::Wait,
            StationsStep::Out,
        ];
        let _ = (&inputs_.part, &inputs_.drilled, &inputs_.tested, &inputs_.part);
        let _ = (&outputs_.motor, &outputs_.drill, &outputs_.test, &outputs_.motor);
    }
};
