//! The header of a recording: what its numbers mean.

use crate::scene::Kind;
use polhode::Error;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// What a recording is of. Every key that a reader may do without has a default.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// What the scene is called.
    #[serde(default)]
    pub title: String,
    /// What happens, in two lines.
    #[serde(default)]
    pub explanation: String,
    /// What to watch.
    #[serde(default)]
    pub look_for: String,
    /// What tells this recording from others of the same scene.
    #[serde(default)]
    pub label: String,
    /// Integrator.
    #[serde(default)]
    pub integrator: String,
    /// Time step \[s\].
    #[serde(default)]
    pub dt: f64,
    /// Time between two frames \[s\].
    #[serde(default)]
    pub frame_interval: f64,
    /// Gravity, world axes [m/s²].
    #[serde(default)]
    pub gravity: [f64; 3],
    /// Whether everything moves in the plane z = 0.
    #[serde(default)]
    pub planar: bool,
    /// What positions are relative to, world coordinates \[m\].
    #[serde(default)]
    pub origin: [f64; 3],
    /// The bodies.
    pub bodies: Vec<BodyInfo>,
    /// What is recorded of each body, in order; `position` and `rotation` are always there.
    pub channels: Vec<ChannelInfo>,
    /// Numbers of the whole scene, one a frame.
    pub series: Vec<SeriesInfo>,
    /// Plots of series.
    #[serde(default)]
    pub plots: Vec<PlotInfo>,
    /// Springs and the like, which are drawn between two points.
    #[serde(default)]
    pub links: Vec<LinkInfo>,
    /// What is drawn at the start; what the channels suggest if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub show: Option<Vec<String>>,
    /// Index of the body that the camera goes with.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub follow: Option<usize>,
}

/// A body of a recording.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BodyInfo {
    /// Name.
    pub name: String,
    /// How it moves.
    pub kind: Kind,
    /// Colour, `#rrggbb`.
    pub color: Option<String>,
    /// Mass \[kg\]; none of a fixed body.
    pub mass: Option<f64>,
    /// Principal moments [kg·m²].
    pub inertia: Option<[f64; 3]>,
    /// Principal axes to body axes, w, x, y, z.
    pub principal_rotation: [f64; 4],
    /// What it looks like.
    pub shapes: Vec<ShapeInfo>,
}

/// A shape of a recording, in the body frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ShapeInfo {
    /// Which form, with its dimensions.
    #[serde(flatten)]
    pub form: FormInfo,
    /// Origin of the form in body coordinates \[m\].
    pub position: [f64; 3],
    /// Form axes to body axes, w, x, y, z.
    pub rotation: [f64; 4],
}

/// A form of a recording; lengths in metres, axis of revolution z.
#[allow(missing_docs, reason = "the dimensions are those of the scene's forms, which say what each is")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum FormInfo {
    Sphere {
        radius: f64,
    },
    Cuboid {
        size: [f64; 3],
    },
    Capsule {
        radius: f64,
        length: f64,
    },
    Cylinder {
        radius: f64,
        length: f64,
    },
    Cone {
        radius: f64,
        length: f64,
    },
    Ellipsoid {
        semi_axes: [f64; 3],
    },
    Torus {
        major: f64,
        minor: f64,
    },
    HalfSpace {
        normal: [f64; 3],
    },
    /// Coordinates x, y, z of the vertices one after another, and three vertices for each triangle.
    Mesh {
        positions: Vec<f64>,
        indices: Vec<u32>,
    },
    Disc {
        radius: f64,
    },
    Rectangle {
        size: [f64; 2],
    },
    Polygon {
        points: Vec<[f64; 2]>,
    },
    Ring {
        inner: f64,
        outer: f64,
    },
}

/// A quantity that is recorded of each body.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ChannelInfo {
    /// Name.
    pub name: String,
    /// How many numbers.
    pub size: usize,
}

/// A number of the whole scene that is recorded in each frame.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SeriesInfo {
    /// Name.
    pub name: String,
    /// What stands beside its curve.
    #[serde(default)]
    pub label: String,
    /// Unit.
    #[serde(default)]
    pub unit: String,
}

/// A plot.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct PlotInfo {
    /// What it is called.
    pub title: String,
    /// Unit on the axis.
    #[serde(default)]
    pub unit: String,
    /// Names of its series.
    pub series: Vec<String>,
    /// Whether the axis is logarithmic.
    #[serde(default)]
    pub log: bool,
}

/// Something that is drawn between two points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LinkInfo {
    /// How it is drawn.
    pub kind: LinkKind,
    /// Index of the first body; the world if absent.
    pub a: Option<usize>,
    /// Point of the first body, its frame, or relative to the origin \[m\].
    pub point_a: [f64; 3],
    /// Index of the second body; the world if absent.
    pub b: Option<usize>,
    /// Point of the second body, its frame, or relative to the origin \[m\].
    pub point_b: [f64; 3],
}

/// How a link is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LinkKind {
    /// A helix.
    Spring,
    /// A spiral.
    Torsion,
    /// A joint that holds a point.
    Pin,
    /// A line.
    Rod,
}

/// The channels that are always there.
const NEEDED: [(&str, usize); 2] = [("position", 3), ("rotation", 4)];
/// Those that may be.
const OPTIONAL: [(&str, usize); 10] = [
    ("center", 3),
    ("velocity", 3),
    ("angular_velocity", 3),
    ("angular_momentum", 3),
    ("force", 3),
    ("torque", 3),
    ("tangent", 3),
    ("normal", 3),
    ("parallel", 3),
    ("matrix", 9),
];

impl ChannelInfo {
    /// The channel `name` with the size that the format gives it.
    pub fn named(name: &str) -> Option<Self> {
        let (name, size) = NEEDED.iter().chain(&OPTIONAL).find(|(known, _)| *known == name)?;
        Some(Self { name: (*name).to_owned(), size: *size })
    }
}

impl Header {
    /// Where the values of a channel begin within those of a body, and how many they are.
    pub fn channel(&self, name: &str) -> Option<(usize, usize)> {
        let mut start = 0;
        for channel in &self.channels {
            if channel.name == name {
                return Some((start, channel.size));
            }
            start += channel.size;
        }
        None
    }

    /// What every header satisfies, written or read.
    ///
    /// # Errors
    /// If a channel is missing, twice there or of the wrong size, a series is twice there, or a plot, a link or `follow`
    /// names what is not there.
    pub fn check(&self) -> Result<(), Error> {
        let mut seen = BTreeSet::new();
        for (i, channel) in self.channels.iter().enumerate() {
            let path = format!("channels[{i}]");
            if ChannelInfo::named(&channel.name).is_some_and(|known| known.size != channel.size) || channel.size == 0 {
                return Err(Error::new(path, format!("{:?} cannot have {} numbers", channel.name, channel.size)));
            }
            if !seen.insert(&channel.name) {
                return Err(Error::new(path, format!("{:?} is there twice", channel.name)));
            }
        }
        if let Some((missing, _)) = NEEDED.iter().find(|(name, _)| self.channel(name).is_none()) {
            return Err(Error::new("channels", format!("there is no {missing:?}")));
        }
        let mut names = BTreeSet::new();
        for (i, series) in self.series.iter().enumerate() {
            if !names.insert(series.name.as_str()) {
                return Err(Error::new(format!("series[{i}]"), format!("{:?} is there twice", series.name)));
            }
        }
        for (i, plot) in self.plots.iter().enumerate() {
            if let Some(name) = plot.series.iter().find(|name| !names.contains(name.as_str())) {
                return Err(Error::new(format!("plots[{i}].series"), format!("there is no series {name:?}")));
            }
        }
        let n_bodies = self.bodies.len();
        let missing = |body: Option<usize>| body.filter(|&body| body >= n_bodies);
        for (i, link) in self.links.iter().enumerate() {
            if let Some(body) = missing(link.a).or(missing(link.b)) {
                return Err(Error::new(format!("links[{i}]"), format!("there is no body {body}, of {n_bodies}")));
            }
        }
        match missing(self.follow) {
            Some(body) => Err(Error::new("follow", format!("there is no body {body}, of {n_bodies}"))),
            None => self
                .bodies
                .iter()
                .enumerate()
                .try_for_each(|(i, body)| body.check_meshes().map_err(|e| e.inside(format!("bodies[{i}]")))),
        }
    }
}

impl BodyInfo {
    fn check_meshes(&self) -> Result<(), Error> {
        for (i, shape) in self.shapes.iter().enumerate() {
            if let FormInfo::Mesh { positions, indices } = &shape.form {
                let n_vertices = positions.len() / 3;
                let whole = positions.len().is_multiple_of(3) && indices.len().is_multiple_of(3);
                if !whole || indices.iter().any(|&vertex| vertex as usize >= n_vertices) {
                    let message = format!("{} indices do not fit {} coordinates", indices.len(), positions.len());
                    return Err(Error::new(format!("shapes[{i}]"), message));
                }
            }
        }
        Ok(())
    }
}
