//! Every scheme: its order by slope, and what it conserves.

mod coupled;
mod exact;
mod free;
mod lanes;
mod reference;
mod slope;
