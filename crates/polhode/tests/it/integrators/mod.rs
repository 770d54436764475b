//! Every scheme: its order by slope, and what it conserves.

mod exact;
mod reference;
