//! What decides about a question: the partial grafcets that it is about, and those that act on them.

use crate::model::{Association, Blinker, Effect, Model, Name, PartialId, Place, Read, StepId, TransitionId, Tree};
use crate::sorted::Set;

/// The partial grafcets that matter.
pub(crate) struct Slice {
    partials: Set<PartialId>,
}

impl Slice {
    /// Those that decide about what these steps and expressions are; `None` where that is all of them.
    pub(crate) fn of(model: &Model, steps: &[StepId], trees: &[&Tree]) -> Option<Self> {
        let mut search = Search { model, partials: Set::new(), places: Set::new(), work: Vec::new() };
        for step in steps {
            search.partial(model.steps[*step].partial);
        }
        for tree in trees {
            search.tree(tree);
        }
        while let Some(next) = search.work.pop() {
            match next {
                Work::Partial(id) => search.follow_partial(id),
                Work::Place(place) => search.follow_place(place),
            }
        }
        (search.partials.len() < model.partials.len()).then_some(Self { partials: search.partials })
    }

    pub(crate) fn has_partial(&self, partial: PartialId) -> bool {
        self.partials.contains(&partial)
    }

    pub(crate) fn has_step(&self, model: &Model, step: StepId) -> bool {
        self.partials.contains(&model.steps[step].partial)
    }

    pub(crate) fn has_transition(&self, model: &Model, transition: TransitionId) -> bool {
        self.partials.contains(&model.transitions[transition].partial)
    }
}

enum Work {
    Partial(PartialId),
    Place(Place),
}

struct Search<'m> {
    model: &'m Model,
    partials: Set<PartialId>,
    places: Set<Place>,
    work: Vec<Work>,
}

impl Search<'_> {
    fn partial(&mut self, id: PartialId) {
        if self.partials.insert(id) {
            self.work.push(Work::Partial(id));
        }
    }

    fn tree(&mut self, tree: &Tree) {
        let mut reads = Vec::new();
        tree.each_read(&mut |read| reads.push(read));
        for read in reads {
            self.read(read);
        }
    }

    fn read(&mut self, read: Read) {
        let model = self.model;
        match read {
            Read::Active(_)
            | Read::Since(_)
            | Read::Elapsed(..)
            | Read::MacroActive(_)
            | Read::MacroSince(_)
            | Read::MacroElapsed(..)
            | Read::Blink(_) => match read.about() {
                Some(Blinker::Step(step)) => self.partial(model.steps[step].partial),
                Some(Blinker::Macro(id)) => {
                    for step in &model.macros[id].steps {
                        self.partial(model.steps[*step].partial);
                    }
                }
                None => {}
            },
            Read::Rising(id) | Read::Falling(id) => self.tree(&model.edges[id].of.tree),
            Read::Delay(id) => self.tree(&model.delays[id].of.tree),
            Read::Memory(id) => self.tree(&model.memories[id].of.tree),
            Read::Name(Name::Var(id)) => self.place(Place::Var(id)),
            Read::Name(Name::Output(id)) => self.place(Place::Output(id)),
            Read::Name(Name::Input(_) | Name::Param(_)) | Read::Ticks(_) => {}
        }
    }

    fn place(&mut self, place: Place) {
        if self.places.insert(place) {
            self.work.push(Work::Place(place));
        }
    }

    /// What its transitions ask for, and who commands it.
    fn follow_partial(&mut self, id: PartialId) {
        let model = self.model;
        for transition in &model.partials[id].transitions {
            for read in &model.transitions[*transition].condition.reads {
                self.read(*read);
            }
        }
        for master in crate::analysis::hierarchy::masters(model, id) {
            self.partial(master);
        }
    }

    /// Who writes it, and what they ask for.
    fn follow_place(&mut self, place: Place) {
        let model = self.model;
        let writes = |effect: &Effect| effect.writes().contains(&place);
        for association in model.associations.values().filter(|association| writes(&association.effect)) {
            self.partial(model.steps[association.step].partial);
            for read in association.reads().into_iter().flatten() {
                self.read(*read);
            }
            self.time(association);
        }
        for transition in model.transitions.values() {
            for effect in transition.clearing.iter().filter(|effect| writes(effect)) {
                self.partial(transition.partial);
                for read in effect.reads().into_iter().flatten() {
                    self.read(*read);
                }
            }
        }
    }

    fn time(&mut self, association: &Association) {
        if let Some(crate::model::TimeRef::Var(id)) = association.time {
            self.place(Place::Var(id));
        }
    }
}
