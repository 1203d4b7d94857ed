//! What a command has to say.

/// What a command prints, and a sentence for each mesh that failed while others were done.
pub struct Answer {
    pub text: String,
    pub failures: Vec<String>,
}

impl From<String> for Answer {
    fn from(text: String) -> Self {
        Self { text, failures: Vec::new() }
    }
}
