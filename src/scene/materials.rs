use super::RockJoint;

/// What an element property set makes of its elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ElementKind {
    /// Elastic constant-strain triangle.
    ElasticTriangle,
    /// Rigid triangle.
    RigidTriangle,
    /// Triangle whose stiffness softens with its largest stretch; no contact.
    SofteningTriangle,
    /// Elastic constant-strain tetrahedron (3D).
    Tetrahedron,
    /// Elastic ten-node tetrahedron without volumetric locking (3D).
    QuadraticTetrahedron,
    /// A type code without mechanics: no force, no mass, no contact.
    Inert(i64),
}

impl ElementKind {
    /// Whether elements of this kind can touch others.
    #[must_use]
    pub fn takes_part_in_contact(self) -> bool {
        matches!(
            self,
            Self::ElasticTriangle
                | Self::RigidTriangle
                | Self::Tetrahedron
                | Self::QuadraticTetrahedron
        )
    }
}

/// How an elastic triangle turns strain into stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ElasticLaw {
    /// Compressible neo-Hookean with the Lamé constants.
    NeoHookean,
    /// Linear in the Green-like strain ½(B − I), plane stress.
    PlaneStress(Isotropy),
    /// The same in plane strain.
    PlaneStrain(Isotropy),
    /// Transversely isotropic along the global axes.
    Transverse(TransverseIsotropy),
}

/// Isotropic elastic constants.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Isotropy {
    /// Young's modulus, Pa.
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

/// Elastic constants of a layered material whose layers follow a global axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransverseIsotropy {
    /// Young's moduli along x and y, Pa.
    pub young: [f64; 2],
    /// Poisson's ratios ν_xy and ν_yx.
    pub poisson: [f64; 2],
    /// Shear modulus, Pa.
    pub shear: f64,
}

/// Element property set.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Kind of element.
    pub kind: ElementKind,
    /// Law of the elastic stress.
    pub elastic_law: ElasticLaw,
    /// First Lamé constant λ, Pa.
    pub lame_lambda: f64,
    /// Shear modulus μ, Pa.
    pub shear_modulus: f64,
    /// Viscosity η of the rate-of-deformation term, Pa·s.
    pub viscosity: f64,
    /// Density, kg/m³.
    pub density: f64,
    /// Contact penalty, Pa; a pair of materials uses the smaller one.
    pub contact_penalty: f64,
    /// Tangential contact penalty, Pa.
    pub tangential_penalty: f64,
    /// Coulomb friction coefficient.
    pub friction: f64,
    /// Coulomb friction coefficient against other materials (classic).
    pub interface_friction: f64,
    /// Whether its elements are taken out of play (Y-Geo).
    pub is_excavated: bool,
    /// Whether its present shape becomes the stress-free one before the next step
    /// (Y-Geo: support is installed).
    pub resets_shape: bool,
    /// Stretch beyond 1 at which a softening triangle reaches damage 1.
    pub softening_stretch: f64,
    /// Whether softening triangles may shrink away from their neighbours.
    pub fractures: bool,
    /// Joint set of joints inside this material; also names the strength of
    /// softening triangles.
    pub joint_set: i32,
    /// If below 1, refinement flags all nodes of the refined elements as boundary.
    pub boundary_marking: i32,
    /// Row of the element state that holds damage.
    pub damage_row: i32,
}

/// Joint property set: cohesive law.
#[derive(Debug, Clone, PartialEq)]
pub struct CohesiveLaw {
    /// Whether joints of this set carry forces (type code 3, 23 in 3D).
    pub is_cohesive: bool,
    /// Tensile strength f_t, Pa.
    pub tensile_strength: f64,
    /// Shear strength f_s, Pa.
    pub shear_strength: f64,
    /// Fracture energy of opening (mode I), J/m².
    pub fracture_energy: f64,
    /// Fracture energy of sliding (mode II), J/m²; the split dialect has one
    /// energy for both.
    pub shear_fracture_energy: f64,
    /// Cohesion, Pa; positive values replace the shear strength by the
    /// Mohr-Coulomb strength at every evaluation.
    pub cohesion: f64,
    /// Friction coefficient of the Mohr-Coulomb strength.
    pub friction: f64,
    /// Friction coefficient that is left when a joint slides in compression (classic).
    pub residual_friction: f64,
    /// Joint penalty, Pa.
    pub penalty: f64,
    /// Tensile strength that sets the peak opening and the softening extent,
    /// Pa: the law's own, or that of a fracture network (spec `mechanics.md` 7.5).
    pub peak_strength: f64,
    /// Fractures of this set (classic).
    pub rock: RockJoint,
    /// Strengths across the layers of a layered material.
    pub layering: Option<Layering>,
}

/// Integration points of the joints between tetrahedra (spec `y2d3d.md` D.7, L.2).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum JointPoints {
    /// Three; a joint fails when all have lost their strength.
    #[default]
    Three,
    /// Seven; a joint fails when five have.
    Seven,
    /// Three in the middles of the edges; a joint fails when two have (`.Y3D`, spec `y3d.md` 4.2).
    MidEdges,
}

/// What becomes of joints between tetrahedra that fail (spec `y2d3d.md` D.7).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FailedJoints {
    /// Their property code becomes −1001, nothing else (the Windows program).
    #[default]
    Left,
    /// It becomes the joint set minus 1000; their nodes, with all that are copies of the same, are
    /// flagged as boundary nodes, and the tetrahedra beside them become a couple (the published
    /// source).
    Opened,
}

/// Strength of joints that depends on their direction: that of the law for
/// joints across the layers, reduced values for joints along them (spec
/// `mechanics.md` 4.3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layering {
    /// Direction of the layers against x, degrees.
    pub angle: f64,
    /// Exponent of the interpolation over the angle between joint and layers.
    pub exponent: f64,
    /// Tensile strength along the layers, Pa.
    pub tensile_strength: f64,
    /// Mode I fracture energy along the layers, J/m².
    pub fracture_energy: f64,
    /// Mode II fracture energy along the layers, J/m².
    pub shear_fracture_energy: f64,
    /// Cohesion along the layers, Pa.
    pub cohesion: f64,
    /// Friction coefficient along the layers.
    pub friction: f64,
}

impl CohesiveLaw {
    /// The law of a joint along `direction` in a layered material (spec
    /// `mechanics.md` 4.3).
    #[must_use]
    pub fn along(&self, layering: &Layering, direction: nalgebra::Vector2<f64>) -> Self {
        let mut inclination = (direction.y / direction.x).atan().to_degrees();
        if inclination < 0.0 {
            inclination += 180.0;
        }
        let mut angle = (layering.angle - inclination).abs();
        if angle > 90.0 {
            angle = 180.0 - angle;
        }
        let weight = (angle / 90.0).powf(layering.exponent);
        let between = |along: f64, across: f64| along + (across - along) * weight;
        let tensile_strength = between(layering.tensile_strength, self.tensile_strength);
        Self {
            tensile_strength,
            peak_strength: tensile_strength,
            fracture_energy: between(layering.fracture_energy, self.fracture_energy),
            shear_fracture_energy: between(
                layering.shear_fracture_energy,
                self.shear_fracture_energy,
            ),
            cohesion: between(layering.cohesion, self.cohesion),
            friction: between(layering.friction, self.friction),
            ..self.clone()
        }
    }

    /// Shear strength of a joint before its first evaluation, Pa.
    #[must_use]
    pub fn initial_shear_strength(&self) -> f64 {
        if self.shear_strength > 0.0 { self.shear_strength } else { self.cohesion }
    }
}
