use clap::Args;

/// `pairtrawl completions`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl completions bash > ~/.local/share/bash-completion/completions/pairtrawl")]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}
