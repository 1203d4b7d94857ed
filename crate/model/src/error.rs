//! What can go wrong with a file, with the element at fault and a remedy.

use strum::IntoStaticStr;
use thiserror::Error;

/// Result with this crate's [`enum@Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Every failure of the crate. The message is one sentence that names what is at fault; [`Error::code`] is for programs, and
/// for those who word what to do in their own terms.
#[derive(Debug, Clone, PartialEq, Error, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// The file's extension and first bytes match no reader.
    #[error("{name}: not a mesh format known here; use glTF, GLB, OBJ, OFF, PLY, STL, 3MF, VTK, GIFTI or FreeSurfer")]
    UnknownFormat {
        /// File name as given.
        name: String,
    },
    /// The file breaks the rules of its format.
    #[error("{format}, {place}: {problem}")]
    Malformed {
        /// Format, for example `"PLY"`.
        format: &'static str,
        /// Where: a line, a byte offset or the name of an element.
        place: String,
        /// What is wrong and what to do about it.
        problem: String,
    },
    /// The file needs something that is not read here (a compression extension, say).
    #[error("{format}: {feature} is not supported; {remedy}")]
    Unsupported {
        /// Format, for example `"glTF"`.
        format: &'static str,
        /// What is needed.
        feature: String,
        /// What to do.
        remedy: String,
    },
    /// A file that this one refers to was not given.
    #[error("the file refers to {uri}, which was not given")]
    MissingResource {
        /// The reference as written in the file.
        uri: String,
    },
    /// There is no such clip.
    #[error("there is no animation {clip}; {}", if clips.is_empty() { "the file has none".to_owned() } else { format!("the file has {clips}") })]
    NoSuchClip {
        /// The name or number asked for.
        clip: String,
        /// The names that there are, separated by commas.
        clips: String,
    },
    /// Parts of a motion do not fit together.
    #[error("the motion cannot be used: {problem}")]
    Motion {
        /// What does not fit.
        problem: String,
    },
    /// A file asks for more memory than one of its size may take: see [`Budget`](crate::io::Budget).
    #[error(
        "the file takes more than {} of memory, the most that a file of {} may take; it is damaged or made to fill memory, save it again",
        of_bytes(*.budget),
        of_bytes(*.size)
    )]
    OverBudget {
        /// Bytes of the file, and of those that it refers to.
        size: u64,
        /// Bytes that it may take.
        budget: u64,
    },
    /// The triangles of a file: there are none, or they name a vertex that does not exist; and whatever else a surface refuses.
    #[error(transparent)]
    Surface(#[from] heatwalk_surface::Error),
}

impl Error {
    /// That of a file without triangles, for a reason in words.
    pub(crate) fn empty(reason: String) -> Self {
        heatwalk_surface::Error::Empty { reason }.into()
    }

    /// Names the kind of failure, in kebab case. It stays the same between versions; messages may not.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Surface(error) => error.code(),
            _ => self.into(),
        }
    }
}

/// Bytes in words.
fn of_bytes(bytes: u64) -> String {
    match bytes {
        0..1_000 => format!("{bytes} bytes"),
        1_000..1_000_000 => format!("{:.0} KB", bytes as f64 / 1e3),
        _ => format!("{:.0} MB", bytes as f64 / 1e6),
    }
}
