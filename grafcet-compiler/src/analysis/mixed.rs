//! Places with actions of two kinds (A8), which is refused: nobody can say what they hold.

use crate::list::List;
use crate::model::{Effect, Model, Place, Qualifier};
use crate::sorted::Set;

/// `grafcet`: places that are asserted while a step is active as well as written at an instant. `sfc`: those that the action
/// control switches and that runs write.
#[must_use]
pub fn mixed(model: &Model) -> Set<Place> {
    let (mut lasting, mut written) = (Set::new(), Set::new());
    for association in model.associations.values() {
        let continuous = association.qualifier.is_continuous();
        let lasts = match &association.effect {
            Effect::Control(_) => continuous || !model.is_grafcet(),
            Effect::Assign(Place::Output(_), _) => {
                continuous && (model.is_grafcet() || association.qualifier == Qualifier::N)
            }
            Effect::Assign(..) => continuous && model.is_grafcet(),
            Effect::Block(_) | Effect::Call(..) => false,
        };
        let places = if lasts { &mut lasting } else { &mut written };
        places.extend(association.effect.writes());
    }
    for effect in model.transitions.values().flat(|transition| &transition.clearing) {
        written.extend(effect.writes());
    }
    lasting.intersection(&written).copied().collect()
}
