//! Laws that tie the parts of this module together: every closed form to a mesh and to particles, every frame to another.

mod closed_forms;
mod frames;
mod meshes;
mod polygons;
mod surfaces;
