//! What a command has to say.

/// What a command prints, and a sentence for each mesh that failed while others were done.
#[derive(Default)]
pub struct Answer {
    pub text: String,
    /// What goes to standard error, because standard output is a file.
    pub aside: String,
    pub failures: Vec<String>,
}

impl From<String> for Answer {
    fn from(text: String) -> Self {
        Self { text, ..Self::default() }
    }
}
