//! The numbers that can be plotted.

use crate::decode::words;
use crate::error::nearest;
use crate::recording::SeriesInfo;

words! {
    /// A number of the whole scene.
    SceneQuantity {
        /// ½ Σ m v² [J].
        "translation" Translation,
        /// ½ Σ ω·L [J].
        "rotation" Rotation,
        /// Potential energy of gravity, fields and springs [J].
        "potential" Potential,
        /// All three together [J].
        "energy" Energy,
        /// Change of the energy since the start, as a share of it or of the kinetic energy, whichever is larger.
        "energy-drift" EnergyDrift,
        /// |Σ p| [kg·m/s].
        "momentum" Momentum,
        /// Change of Σ p since the start, as a share of Σ |p|.
        "momentum-drift" MomentumDrift,
        /// |Σ x × p + L| about the origin [kg·m²/s].
        "angular-momentum" AngularMomentum,
        /// Change of the angular momentum since the start, as a share of the sum of all bodies' amounts of it.
        "angular-momentum-drift" AngularMomentumDrift,
        /// Largest angle between a body and the same body in the reference run [rad].
        "attitude-error" AttitudeError,
        /// Largest element of RᵀR − 1 over all bodies.
        "orthogonality" Orthogonality,
        /// Determinant of R of the first dynamic body, 1 for a rotation.
        "determinant" Determinant,
        /// Largest distance of a pinned point from where it is held [m].
        "pin-gap" PinGap,
    }
}

words! {
    /// A number of one body.
    BodyQuantity {
        /// Centre of mass, x [m].
        "x" X,
        /// Centre of mass, y [m].
        "y" Y,
        /// Centre of mass, z [m].
        "z" Z,
        /// Velocity, x [m/s].
        "vx" Vx,
        /// Velocity, y [m/s].
        "vy" Vy,
        /// Velocity, z [m/s].
        "vz" Vz,
        /// |v| [m/s].
        "speed" Speed,
        /// Angular velocity, x [rad/s].
        "wx" Wx,
        /// Angular velocity, y [rad/s].
        "wy" Wy,
        /// Angular velocity, z [rad/s].
        "wz" Wz,
        /// |ω| [rad/s].
        "spin" Spin,
        /// Angular velocity along the first body axis [rad/s].
        "w1" W1,
        /// Angular velocity along the second body axis [rad/s].
        "w2" W2,
        /// Angular velocity along the third body axis [rad/s].
        "w3" W3,
        /// Momentum, x [kg·m/s].
        "px" Px,
        /// Momentum, y [kg·m/s].
        "py" Py,
        /// Momentum, z [kg·m/s].
        "pz" Pz,
        /// Angular momentum about the centre of mass, x [kg·m²/s].
        "lx" Lx,
        /// Angular momentum about the centre of mass, y [kg·m²/s].
        "ly" Ly,
        /// Angular momentum about the centre of mass, z [kg·m²/s].
        "lz" Lz,
        /// |L| about the centre of mass [kg·m²/s].
        "l" L,
        /// Kinetic energy, both parts [J].
        "kinetic" Kinetic,
        /// Angle between the body's third axis and the vertical [rad].
        "tilt" Tilt,
        /// Curvature of the path of the centre of mass [1/m].
        "curvature" Curvature,
        /// Torsion of the path of the centre of mass [1/m].
        "torsion" Torsion,
    }
}

impl SceneQuantity {
    fn label_and_unit(self) -> (&'static str, &'static str) {
        match self {
            Self::Translation => ("½mv²", "J"),
            Self::Rotation => ("½ω·L", "J"),
            Self::Potential => ("U", "J"),
            Self::Energy => ("E", "J"),
            Self::EnergyDrift => ("ΔE/E", ""),
            Self::Momentum => ("|p|", "kg·m/s"),
            Self::MomentumDrift => ("Δp/p", ""),
            Self::AngularMomentum => ("|L|", "kg·m²/s"),
            Self::AngularMomentumDrift => ("ΔL/L", ""),
            Self::AttitudeError => ("attitude error", "rad"),
            Self::Orthogonality => ("|RᵀR−1|", ""),
            Self::Determinant => ("det R", ""),
            Self::PinGap => ("gap", "m"),
        }
    }
}

impl BodyQuantity {
    fn unit(self) -> &'static str {
        match self {
            Self::X | Self::Y | Self::Z => "m",
            Self::Vx | Self::Vy | Self::Vz | Self::Speed => "m/s",
            Self::Wx | Self::Wy | Self::Wz | Self::Spin | Self::W1 | Self::W2 | Self::W3 => "rad/s",
            Self::Px | Self::Py | Self::Pz => "kg·m/s",
            Self::Lx | Self::Ly | Self::Lz | Self::L => "kg·m²/s",
            Self::Kinetic => "J",
            Self::Tilt => "rad",
            Self::Curvature | Self::Torsion => "1/m",
        }
    }
}

/// What a series holds; a body by its name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    Scene(SceneQuantity),
    Body(String, BodyQuantity),
}

impl Quantity {
    /// From the name of a series, `energy` or `BODY.x`; the body is not looked up here.
    ///
    /// # Errors
    /// What is wrong with the name, and what it may have meant.
    pub(crate) fn parse(name: &str) -> Result<Self, (String, Option<String>)> {
        let shown: String = name.chars().take(64).collect();
        let guess = |guess: Option<&str>| guess.map_or(String::new(), |guess| format!(", did you mean \"{guess}\"?"));
        if let Some(found) = SceneQuantity::ALL.iter().find(|quantity| quantity.word() == name) {
            return Ok(Self::Scene(*found));
        }
        let Some((body, word)) = name.rsplit_once('.') else {
            let near = guess(nearest(name, SceneQuantity::ALL.iter().map(|quantity| quantity.word())));
            let all: Vec<&str> = SceneQuantity::ALL.iter().map(|quantity| quantity.word()).collect();
            let help = format!("one of {}; or of a body: \"BODY.speed\"", crate::decode::list(&all));
            return Err((format!("there is no series {shown:?}{near}"), Some(help)));
        };
        if let Some(found) = BodyQuantity::ALL.iter().find(|quantity| quantity.word() == word) {
            return Ok(Self::Body(body.to_owned(), *found));
        }
        let near = guess(nearest(word, BodyQuantity::ALL.iter().map(|quantity| quantity.word())));
        let all: Vec<&str> = BodyQuantity::ALL.iter().map(|quantity| quantity.word()).collect();
        Err((format!("there is no {shown:?} of a body{near}"), Some(format!("one of {}", crate::decode::list(&all)))))
    }

    pub(crate) fn info(&self) -> SeriesInfo {
        let (name, label, unit) = match self {
            Self::Scene(quantity) => {
                let (label, unit) = quantity.label_and_unit();
                (quantity.word().to_owned(), label.to_owned(), unit)
            }
            Self::Body(body, quantity) => {
                let name = format!("{body}.{}", quantity.word());
                (name.clone(), name, quantity.unit())
            }
        };
        SeriesInfo { name, label, unit: unit.to_owned() }
    }
}
