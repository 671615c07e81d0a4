//! What can be shown of a frame.

use std::str::FromStr;

use ypsilon_converters::stress_measures::{
    SymmetricTensor, mean, plane, principal, tresca, von_mises,
};

use crate::error::PostError;
use crate::point::in_words;
use crate::results::Frame;
use crate::vectors::length;

/// What kind of number a field is: decides unit and name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Pa.
    Stress,
    /// m.
    Length,
    /// m/s.
    Velocity,
    /// N.
    Force,
    /// Without unit.
    Number,
}

impl Quantity {
    /// Its unit; empty for numbers.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Stress => "Pa",
            Self::Length => "m",
            Self::Velocity => "m/s",
            Self::Force => "N",
            Self::Number => "",
        }
    }
}

macro_rules! fields {
    ($($(#[$doc:meta])* $variant:ident: $name:literal, $label:literal, $quantity:ident, $signed:literal;)*) => {
        /// A scalar field of a frame. Stresses belong to elements, the rest to nodes.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Field {
            $($(#[$doc])* $variant,)*
        }

        impl Field {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$variant,)*];

            /// Its name on the command line and in tables.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// Its name in pictures.
            #[must_use]
            pub fn label(self) -> &'static str {
                match self { $(Self::$variant => $label,)* }
            }

            /// What kind of number it is.
            #[must_use]
            pub fn quantity(self) -> Quantity {
                match self { $(Self::$variant => Quantity::$quantity,)* }
            }

            /// Whether its sign has a meaning.
            #[must_use]
            pub fn is_signed(self) -> bool {
                match self { $(Self::$variant => $signed,)* }
            }
        }
    };
}

fields! {
    /// Von Mises stress, σzz included.
    VonMises: "von-mises", "von Mises stress", Stress, false;
    /// Von Mises stress with σzz = 0, as LS-PrePost shows it for Y's files, of plane results.
    VonMisesInPlane: "von-mises-plane", "von Mises stress (σzz = 0)", Stress, false;
    /// Tresca stress: the difference of the largest and the smallest principal stress.
    Tresca: "tresca", "Tresca stress", Stress, false;
    /// σxx.
    StressXx: "sxx", "stress σxx", Stress, true;
    /// σyy.
    StressYy: "syy", "stress σyy", Stress, true;
    /// σxy.
    StressXy: "sxy", "shear stress σxy", Stress, true;
    /// σzz; in the plane that out of it.
    StressZz: "szz", "stress σzz", Stress, true;
    /// σyz, in space.
    StressYz: "syz", "shear stress σyz", Stress, true;
    /// σzx, in space.
    StressZx: "szx", "shear stress σzx", Stress, true;
    /// Largest principal stress of the three.
    Principal1: "s1", "principal stress σ1", Stress, true;
    /// Middle principal stress.
    Principal2: "s2", "principal stress σ2", Stress, true;
    /// Smallest principal stress of the three.
    Principal3: "s3", "principal stress σ3", Stress, true;
    /// Larger principal stress in the plane, of plane results.
    PlaneMaximum: "smax", "larger principal stress in the plane", Stress, true;
    /// Smaller principal stress in the plane, of plane results.
    PlaneMinimum: "smin", "smaller principal stress in the plane", Stress, true;
    /// Mean stress: a third of the trace.
    MeanStress: "mean-stress", "mean stress", Stress, true;
    /// Magnitude of the displacement.
    Displacement: "u", "displacement", Length, false;
    /// Horizontal displacement.
    DisplacementX: "ux", "displacement ux", Length, true;
    /// Vertical displacement.
    DisplacementY: "uy", "displacement uy", Length, true;
    /// Z component of the displacement, in space.
    DisplacementZ: "uz", "displacement uz", Length, true;
    /// Speed.
    Velocity: "v", "velocity", Velocity, false;
    /// Horizontal velocity.
    VelocityX: "vx", "velocity vx", Velocity, true;
    /// Vertical velocity.
    VelocityY: "vy", "velocity vy", Velocity, true;
    /// Z component of the velocity, in space.
    VelocityZ: "vz", "velocity vz", Velocity, true;
    /// Magnitude of the nodal force.
    Force: "f", "nodal force", Force, false;
    /// Horizontal nodal force.
    ForceX: "fx", "nodal force fx", Force, true;
    /// Vertical nodal force.
    ForceY: "fy", "nodal force fy", Force, true;
    /// Z component of the nodal force, in space.
    ForceZ: "fz", "nodal force fz", Force, true;
    /// Horizontal coordinate.
    CoordinateX: "x", "coordinate x", Length, true;
    /// Vertical coordinate.
    CoordinateY: "y", "coordinate y", Length, true;
    /// Z coordinate, in space.
    CoordinateZ: "z", "coordinate z", Length, true;
    /// Damage of softening elements.
    Damage: "damage", "damage", Number, false;
    /// Property set (material) of the deck, from 0.
    Material: "material", "material", Number, false;
}

impl FromStr for Field {
    type Err = PostError;

    fn from_str(words: &str) -> Result<Self, PostError> {
        let name = words.trim().to_ascii_lowercase().replace([' ', '_'], "-");
        let name = name.strip_prefix("sigma-").map_or(name.clone(), |rest| format!("s{rest}"));
        let name = match name.as_str() {
            "vonmises" | "mises" => "von-mises",
            "displacement" => "u",
            "velocity" | "speed" => "v",
            "force" => "f",
            name => name,
        };
        Self::ALL.iter().copied().find(|field| field.name() == name).ok_or_else(|| {
            let names: Vec<&str> = Self::ALL.iter().map(|field| field.name()).collect();
            PostError::words("the field", words, format!("there are {}", names.join(", ")))
        })
    }
}

/// Values of a field in a frame.
#[derive(Debug, Clone, PartialEq)]
pub enum FieldValues {
    /// One per element.
    Elements(Vec<f64>),
    /// One per node.
    Nodes(Vec<f64>),
}

impl FieldValues {
    /// Values at the corners of each element.
    #[must_use]
    pub fn corners<const D: usize, const C: usize>(&self, frame: &Frame<D, C>) -> Vec<[f64; C]> {
        match self {
            Self::Elements(values) => values.iter().map(|&v| [v; C]).collect(),
            Self::Nodes(values) => {
                let at = |n: u32| values.get(n as usize).copied().unwrap_or(f64::NAN);
                frame.elements.iter().map(|corners| corners.map(at)).collect()
            }
        }
    }

    /// One value per element: of nodes the mean of its corners.
    #[must_use]
    pub fn of_elements<const D: usize, const C: usize>(&self, frame: &Frame<D, C>) -> Vec<f64> {
        match self {
            Self::Elements(values) => values.clone(),
            Self::Nodes(_) => {
                let mean = |corners: &[f64; C]| corners.iter().sum::<f64>() / C as f64;
                self.corners(frame).iter().map(mean).collect()
            }
        }
    }

    /// The value within an element, where its corners have these weights: constant for values of
    /// elements, by the shape functions of the element for those of nodes.
    #[must_use]
    pub fn within<const D: usize, const C: usize>(
        &self,
        frame: &Frame<D, C>,
        element: usize,
        weights: [f64; C],
    ) -> f64 {
        let at = |values: &[f64], index: usize| values.get(index).copied().unwrap_or(f64::NAN);
        match self {
            Self::Elements(values) => at(values, element),
            Self::Nodes(values) => {
                let nodes = frame.shape(element, weights);
                nodes.map(|(node, weight)| weight * at(values, node as usize)).sum()
            }
        }
    }

    /// All values.
    #[must_use]
    pub fn all(&self) -> &[f64] {
        match self {
            Self::Elements(values) | Self::Nodes(values) => values,
        }
    }
}

impl Field {
    /// Its name and unit: `syy (Pa)`.
    #[must_use]
    pub fn heading(self) -> String {
        match self.quantity().unit() {
            "" => self.name().to_owned(),
            unit => format!("{} ({unit})", self.name()),
        }
    }

    /// Whether it belongs to elements, not to nodes.
    #[must_use]
    pub fn is_of_elements(self) -> bool {
        matches!(self.quantity(), Quantity::Stress | Quantity::Number)
    }

    /// Whether results of so many dimensions can have it.
    #[must_use]
    pub fn fits(self, dimension: usize) -> bool {
        use Field::{
            CoordinateZ, DisplacementZ, ForceZ, PlaneMaximum, PlaneMinimum, StressYz, StressZx,
            VelocityZ, VonMisesInPlane,
        };
        match self {
            StressYz | StressZx | DisplacementZ | VelocityZ | ForceZ | CoordinateZ => dimension > 2,
            VonMisesInPlane | PlaneMaximum | PlaneMinimum => dimension == 2,
            _ => true,
        }
    }

    /// Checks that results of so many dimensions can have it.
    ///
    /// # Errors
    /// If they cannot.
    pub fn check(self, dimension: usize) -> Result<(), PostError> {
        if self.fits(dimension) {
            return Ok(());
        }
        let is_alike = |field: &&Self| field.fits(dimension) && field.quantity() == self.quantity();
        let others: Vec<&str> = Self::ALL.iter().filter(is_alike).map(|f| f.name()).collect();
        Err(PostError::Nothing(format!(
            "bodies {} have no field {}; expected {}",
            in_words(dimension),
            self.name(),
            others.join(", ")
        )))
    }

    /// Its values in a frame.
    ///
    /// # Errors
    /// If bodies of this dimension do not have the field, or the frame lacks the array that it
    /// comes from.
    pub fn values<const D: usize, const C: usize>(
        self,
        frame: &Frame<D, C>,
    ) -> Result<FieldValues, PostError> {
        self.check(D)?;
        if self.is_of_elements() {
            self.of_elements(frame).map(FieldValues::Elements)
        } else {
            self.of_nodes(frame).map(FieldValues::Nodes)
        }
    }

    fn of_elements<const D: usize, const C: usize>(
        self,
        frame: &Frame<D, C>,
    ) -> Result<Vec<f64>, PostError> {
        if self == Self::Material {
            return Ok(frame.property.iter().map(|&p| f64::from(p)).collect());
        }
        if self == Self::Damage {
            let damage = frame.damage.clone();
            return damage.ok_or_else(|| {
                self.missing("damage of triangles", "only softening triangles (I1PTYP 2) have it")
            });
        }
        let stresses = frame.stress.as_ref();
        let stresses = stresses.ok_or_else(|| self.missing("stresses", "run the deck again"))?;
        let value = |tensor: &SymmetricTensor| {
            let &[xx, yy, zz, xy, yz, zx] = tensor;
            let (centre, radius) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
            match self {
                Self::VonMises => von_mises(tensor),
                Self::VonMisesInPlane => von_mises(&plane(xx, yy, 0.0, xy)),
                Self::Tresca => tresca(tensor),
                Self::StressXx => xx,
                Self::StressYy => yy,
                Self::StressXy => xy,
                Self::StressZz => zz,
                Self::StressYz => yz,
                Self::StressZx => zx,
                Self::Principal1 => principal(tensor)[0],
                Self::Principal2 => principal(tensor)[1],
                Self::Principal3 => principal(tensor)[2],
                Self::PlaneMaximum => centre + radius,
                Self::PlaneMinimum => centre - radius,
                Self::MeanStress => mean(tensor),
                _ => f64::NAN,
            }
        };
        Ok(stresses.iter().map(value).collect())
    }

    fn of_nodes<const D: usize, const C: usize>(
        self,
        frame: &Frame<D, C>,
    ) -> Result<Vec<f64>, PostError> {
        use Field::{
            CoordinateX, CoordinateY, CoordinateZ, DisplacementX, DisplacementY, DisplacementZ,
            ForceX, ForceY, ForceZ, VelocityX, VelocityY, VelocityZ,
        };
        let vtu = "VTU files of Ypsilon have them (run with --formats vtu)";
        let (vectors, what) = match self.quantity() {
            Quantity::Velocity => (frame.velocity.as_ref(), "velocities"),
            Quantity::Force => (frame.force.as_ref(), "nodal forces"),
            _ if matches!(self, CoordinateX | CoordinateY | CoordinateZ) => {
                (Some(&frame.points), "coordinates")
            }
            _ => (frame.displacement.as_ref(), "displacements"),
        };
        let vectors = vectors.ok_or_else(|| self.missing(what, vtu))?;
        let axis = match self {
            DisplacementX | VelocityX | ForceX | CoordinateX => Some(0),
            DisplacementY | VelocityY | ForceY | CoordinateY => Some(1),
            DisplacementZ | VelocityZ | ForceZ | CoordinateZ => Some(2),
            _ => None,
        };
        let value = |v: &[f64; D]| match axis {
            Some(axis) => v.get(axis).copied().unwrap_or(f64::NAN),
            None => length(*v),
        };
        Ok(vectors.iter().map(value).collect())
    }

    fn missing(self, array: &'static str, remedy: &'static str) -> PostError {
        PostError::MissingArray { array, wanted: format!("the field {}", self.name()), remedy }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame() -> Frame {
        Frame {
            points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            displacement: Some(vec![[3.0, 4.0], [0.0, 0.0], [0.0, -1.0]]),
            elements: vec![[0, 1, 2]],
            property: vec![1],
            stress: Some(vec![plane(3.0, -1.0, 0.5, 2.0)]),
            ..Frame::default()
        }
    }

    #[test]
    fn stresses_have_their_textbook_values() {
        let value = |name: &str| {
            let field: Field = name.parse().expect("a field");
            field.values(&frame()).expect("values").all()[0]
        };
        let radius = 8.0_f64.sqrt();
        for (name, expected) in [
            ("smax", 1.0 + radius),
            ("smin", 1.0 - radius),
            ("s2", 0.5),
            ("tresca", 2.0 * radius),
            ("sigma_yy", -1.0),
            ("mean-stress", 2.5 / 3.0),
            ("von-mises-plane", (9.0_f64 + 3.0 + 1.0 + 12.0).sqrt()),
            ("u", 5.0),
            ("material", 1.0),
        ] {
            assert!((value(name) - expected).abs() < 1e-14, "{name}: {}", value(name));
        }
    }

    #[test]
    fn fields_of_space_have_three_components() {
        let frame = Frame::<3, 4> {
            points: vec![[0.0; 3]; 4],
            displacement: Some(vec![[2.0, 3.0, -6.0]; 4]),
            elements: vec![[0, 1, 2, 3]],
            property: vec![0],
            stress: Some(vec![[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]]),
            ..Frame::default()
        };
        let value = |name: &str| {
            let field: Field = name.parse().expect("a field");
            field.values(&frame).map(|values| values.all()[0])
        };
        for (name, expected) in [("uz", -6.0), ("u", 7.0), ("szz", 3.0), ("syz", 5.0), ("szx", 6.0)]
        {
            let found = value(name).expect("a value");
            assert!((found - expected).abs() < 1e-14, "{name}: {found}");
        }
        let fault = value("smax").expect_err("a fault").to_string();
        assert!(fault.starts_with("bodies in space have no field smax; expected von-mises, "));
    }

    #[test]
    fn fields_of_space_are_none_of_the_plane() {
        let fault = |name: &str| {
            let field: Field = name.parse().expect("a field");
            field.values(&frame()).expect_err("a fault").to_string()
        };
        assert_eq!(fault("vz"), "bodies in the plane have no field vz; expected v, vx, vy");
        for field in Field::ALL.iter().filter(|field| !field.fits(2)) {
            assert!(fault(field.name()).contains("in the plane have no field"));
        }
    }

    #[test]
    fn what_is_missing_is_told() {
        let fault = Field::Velocity.values(&frame()).expect_err("a fault").to_string();
        assert!(fault.contains("no velocities, which the field v needs"), "{fault}");
        let fault = "stress".parse::<Field>().expect_err("a fault").to_string();
        assert!(fault.contains("there are von-mises, "), "{fault}");
    }
}
