//! The house: rules of structure and style that a machine can hold, so that no review has to.
//!
//! Every rule is a function from text to complaints. It runs on the repository, and beside it on snippets that must fail:
//! a rule that cannot fail holds nothing.

mod dependencies;
mod documents;
mod floors;
mod question;
mod size;
mod source;
mod words;
