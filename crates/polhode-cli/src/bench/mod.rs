//! bench
#[derive(Debug, clap::Args)]
/// a
pub struct Arguments {}
impl Arguments {
    pub(crate) fn execute(&self, _: &mut crate::Terminal) -> Result<crate::Outcome, crate::Refusal> {
        Ok(crate::Outcome::Done)
    }
}
