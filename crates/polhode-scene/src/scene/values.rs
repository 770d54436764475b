//! The small values of a scene that may be written in more than one way.

use crate::decode::{Decode, Definitions, Item, Sink, mismatch};
use polhode::math::{Mat3, Quat, Vec3};
use serde_json::{Value as Json, json};
use std::ops::Deref;
use toml::de::DeValue;

/// One value or a list of them.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct OneOrMany<T>(pub Vec<T>);

impl<T> Deref for OneOrMany<T> {
    type Target = Vec<T>;
    fn deref(&self) -> &Vec<T> {
        &self.0
    }
}

impl<T: Decode> Decode for OneOrMany<T> {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        match item.value {
            DeValue::Array(_) => Vec::decode(item, out).map(Self),
            _ => T::decode(item, out).map(|one| Self(vec![one])),
        }
    }
    fn missing() -> Option<Self> {
        Some(Self(Vec::new()))
    }
    fn schema(definitions: &mut Definitions) -> Json {
        let one = T::schema(definitions);
        json!({ "anyOf": [one, { "type": "array", "items": one }] })
    }
}

/// Gravity: a vector [m/s²], or one number, how strongly it pulls down: along −z, in a planar scene along −y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gravity {
    /// World axes [m/s²].
    Vector(Vec3),
    /// Downwards [m/s²].
    Down(f64),
}

impl Gravity {
    /// World axes [m/s²].
    pub fn vector(self, planar: bool) -> Vec3 {
        match self {
            Self::Vector(g) => g,
            Self::Down(g) if planar => Vec3::new(0.0, -g, 0.0),
            Self::Down(g) => Vec3::new(0.0, 0.0, -g),
        }
    }
}

impl Decode for Gravity {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        match item.value {
            DeValue::Array(_) => <[f64; 3]>::decode(item, out).map(|g| Self::Vector(g.into())),
            _ => f64::decode(item, out).map(Self::Down),
        }
    }
    fn schema(definitions: &mut Definitions) -> Json {
        json!({ "anyOf": [{ "type": "number" }, <[f64; 3]>::schema(definitions)] })
    }
}

/// A time step \[s\]: a number, or a quotient such as `"1/60"`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeStep(pub f64);

impl Decode for TimeStep {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        let seconds = match item.value {
            DeValue::String(text) => {
                let quotient = text.split_once('/').and_then(|(a, b)| {
                    let (a, b): (f64, f64) = (a.trim().parse().ok()?, b.trim().parse().ok()?);
                    Some(a / b)
                });
                match quotient {
                    Some(seconds) => seconds,
                    None => return mismatch(item, "a number of seconds, or a quotient such as \"1/60\"", out),
                }
            }
            _ => f64::decode(item, out)?,
        };
        if seconds.is_finite() && seconds > 0.0 {
            return Some(Self(seconds));
        }
        out.refuse(item, format!("a time step must be positive and finite, found {seconds}"), None)
    }
    fn schema(_: &mut Definitions) -> Json {
        json!({ "anyOf": [{ "type": "number", "exclusiveMinimum": 0 }, { "type": "string", "pattern": "^[^/]+/[^/]+$" }] })
    }
}

/// A rotation, body axes to world axes: a quaternion `[w, x, y, z]`, `{ axis, degrees }`, or `{ euler_degrees }`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation(pub Quat);

impl Default for Rotation {
    fn default() -> Self {
        Self(Quat::IDENTITY)
    }
}

crate::decode::table! {
    /// A turn about an axis.
    "a rotation" AxisAngle {
        /// The axis, of any length but zero.
        axis: [f64; 3];
        /// The angle [°], positive by the right hand.
        degrees: Option<f64>;
        /// The angle [rad], instead of `degrees`.
        radians: Option<f64>;
    }
}

crate::decode::table! {
    /// Turns about x, then about y, then about z, each about the world's fixed axis.
    "a rotation" EulerAngles {
        /// The three angles [°].
        euler_degrees: [f64; 3];
    }
}

impl Rotation {
    fn about(axis: [f64; 3], angle: f64) -> Option<Quat> {
        Vec3::from(axis).direction().map(|axis| Quat::from_axis_angle(axis, angle)).filter(|q| q.is_finite())
    }
}

impl Decode for Rotation {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        match item.value {
            DeValue::Array(_) => {
                let [w, x, y, z] = <[f64; 4]>::decode(item, out)?;
                // Scaled first, so that neither tiny nor huge components lose the direction.
                let big = [w, x, y, z].into_iter().map(f64::abs).fold(0.0, f64::max);
                let q = Quat::new(w / big, x / big, y / big, z / big).normalized();
                if q.is_finite() { Some(Self(q)) } else { out.refuse(item, "a quaternion must not be zero", None) }
            }
            DeValue::Table(table) if table.contains_key("euler_degrees") => {
                let [x, y, z] = EulerAngles::decode(item, out)?.euler_degrees;
                let turns = [([0.0, 0.0, 1.0], z), ([0.0, 1.0, 0.0], y), ([1.0, 0.0, 0.0], x)];
                let q = turns
                    .into_iter()
                    .try_fold(Quat::IDENTITY, |q, (axis, degrees)| Some(q * Self::about(axis, degrees.to_radians())?));
                q.map(|q| Self(q.normalized())).or_else(|| out.refuse(item, "the angles are too large", None))
            }
            DeValue::Table(_) => {
                let AxisAngle { axis, degrees, radians } = AxisAngle::decode(item, out)?;
                let angle = match (degrees, radians) {
                    (Some(degrees), None) => degrees.to_radians(),
                    (None, Some(radians)) => radians,
                    _ => return out.refuse(item, "give the angle once, as `degrees` or as `radians`", None),
                };
                match Self::about(axis, angle) {
                    Some(q) => Some(Self(q)),
                    None => out.refuse(item, "the axis of a rotation must not be zero", None),
                }
            }
            _ => mismatch(item, "a rotation: [w, x, y, z], { axis, degrees } or { euler_degrees }", out),
        }
    }
    fn missing() -> Option<Self> {
        Some(Self::default())
    }
    fn schema(definitions: &mut Definitions) -> Json {
        let quaternion = <[f64; 4]>::schema(definitions);
        json!({ "anyOf": [quaternion, AxisAngle::schema(definitions), EulerAngles::schema(definitions)] })
    }
}

/// A tensor of inertia about the centre of mass [kg·m²]: three principal moments, a 3×3 matrix, or in a planar scene one number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Inertia {
    /// The moment about the normal of the plane.
    Planar(f64),
    /// Moments about the body's own axes.
    Moments(Vec3),
    /// The whole tensor, in body axes.
    Tensor(Mat3),
}

impl Decode for Inertia {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        let DeValue::Array(items) = item.value else { return f64::decode(item, out).map(Self::Planar) };
        if items.iter().any(|row| row.get_ref().is_array()) {
            let rows = <[[f64; 3]; 3]>::decode(item, out)?.map(Vec3::from);
            return Some(Self::Tensor(Mat3::from_rows(rows[0], rows[1], rows[2])));
        }
        <[f64; 3]>::decode(item, out).map(|moments| Self::Moments(moments.into()))
    }
    fn schema(definitions: &mut Definitions) -> Json {
        json!({ "anyOf": [{ "type": "number" }, <[f64; 3]>::schema(definitions), <[[f64; 3]; 3]>::schema(definitions)] })
    }
}

/// A colour, `"#rrggbb"`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Color(pub String);

impl Decode for Color {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        let text = String::decode(item, out)?;
        match text.strip_prefix('#') {
            Some(digits) if digits.len() == 6 && digits.bytes().all(|b| b.is_ascii_hexdigit()) => Some(Self(text)),
            _ => mismatch(item, "a colour such as \"#4f8fd0\"", out),
        }
    }
    fn schema(_: &mut Definitions) -> Json {
        json!({ "type": "string", "pattern": "^#[0-9a-fA-F]{6}$" })
    }
}
