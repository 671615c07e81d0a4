/// What an element property set makes of its elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ElementKind {
    /// Elastic constant-strain triangle.
    ElasticTriangle,
    /// Rigid triangle.
    RigidTriangle,
    /// Triangle whose stiffness softens with its largest stretch; no contact.
    SofteningTriangle,
    /// A type code without mechanics: no force, no mass, no contact.
    Inert(i64),
}

impl ElementKind {
    /// Whether elements of this kind can touch others.
    #[must_use]
    pub fn takes_part_in_contact(self) -> bool {
        matches!(self, Self::ElasticTriangle | Self::RigidTriangle)
    }
}

/// Element property set.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Kind of element.
    pub kind: ElementKind,
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

/// Joint property set: cohesive law of 2D joints.
#[derive(Debug, Clone, PartialEq)]
pub struct CohesiveLaw {
    /// Whether joints of this set carry forces (type code 3).
    pub is_cohesive: bool,
    /// Tensile strength f_t, Pa.
    pub tensile_strength: f64,
    /// Shear strength f_s, Pa.
    pub shear_strength: f64,
    /// Fracture energy G_f, J/m².
    pub fracture_energy: f64,
    /// Cohesion, Pa; positive values replace the shear strength by the
    /// Mohr-Coulomb strength at every evaluation.
    pub cohesion: f64,
    /// Friction coefficient of the Mohr-Coulomb strength.
    pub friction: f64,
    /// Joint penalty, Pa.
    pub penalty: f64,
}

impl CohesiveLaw {
    /// Shear strength of a joint before its first evaluation, Pa.
    #[must_use]
    pub fn initial_shear_strength(&self) -> f64 {
        if self.shear_strength > 0.0 { self.shear_strength } else { self.cohesion }
    }
}
