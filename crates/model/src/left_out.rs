use crate::Scene;
use std::fmt;

/// An object that a plan leaves where it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Its index in the scene.
    pub object: usize,
    /// On what grounds.
    pub why: LeftWhy,
    /// The reason in full, for people.
    pub text: String,
}

/// On what grounds an object is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LeftWhy {
    /// There is a proof that no plan can sweep it.
    Proven,
    /// No certified plan was found that includes it. There may be one.
    NotFound,
}

impl LeftWhy {
    /// All, in the order of their declaration.
    pub const ALL: [Self; 2] = [Self::Proven, Self::NotFound];

    /// The name in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Proven => "proven",
            Self::NotFound => "not_found",
        }
    }

    /// The reason in a few words, for people.
    pub const fn describe(self) -> &'static str {
        match self {
            Self::Proven => "proven impossible",
            Self::NotFound => "no plan found with it",
        }
    }
}

impl fmt::Display for LeftWhy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl Scene {
    /// The same scene with these objects left where they are, besides those that are left already. An index that the
    /// scene does not have is ignored.
    #[must_use]
    pub fn leaving(&self, objects: impl IntoIterator<Item = usize>) -> Self {
        let mut scene = self.clone();
        for object in objects {
            if let Some(object) = scene.objects.get_mut(object) {
                object.leave = true;
            }
        }
        scene
    }

    /// How many objects are to be gathered.
    pub fn wanted(&self) -> usize {
        self.objects.iter().filter(|object| !object.leave).count()
    }

    /// The objects that are left where they are, ascending.
    pub fn left(&self) -> Vec<usize> {
        let left = self.objects.iter().enumerate().filter(|(_, o)| o.leave);
        left.map(|(i, _)| i).collect()
    }
}
