//! The frame of acoustic events.

use std::io::{self, Write};

use super::vtk_xml::{self, SIX, single};

/// The breaking of a joint that released kinetic energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AcousticEvent {
    /// Mean of the four corners of the joint when it broke.
    pub position: [f64; 2],
    /// Change of the kinetic energy around it, above zero: the energy of the event (J in SI
    /// decks).
    pub energy: f64,
    /// Work of the joint, negative where it took up energy (J).
    pub fracture_energy: f64,
    /// Failure mode of the joint, as in [`super::BrokenJoint::failure_mode`].
    pub failure_mode: f64,
}

impl AcousticEvent {
    /// Magnitude of the event, from the energy in single precision. Y-Geo writes e⁻⁹ where the
    /// unit asks for 10⁻⁹.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        ((f64::from(self.energy as f32) * (-9.0_f64).exp()).log10() - 4.8) / 1.5
    }
}

/// Writes `PREFIX_acoustic_N.vtu` (outputs.md, 5.5): all events from the beginning of the run,
/// in Y-Geo in ascending order of the joints' properties and numbers.
pub fn write_acoustic_events(out: &mut impl Write, events: &[AcousticEvent]) -> io::Result<()> {
    vtk_xml::open_point_cloud(out, events.len())?;
    out.write_all(
        b"<PointData Scalars='acoustic_energy acoustic_magnitude acoustic_fracture_energy \
        acoustic_event_mode'>\n",
    )?;
    let mut scalars = |name, value: fn(&AcousticEvent) -> f64| {
        vtk_xml::float_array(out, name, SIX, events.iter().map(|event| value(event) as f32))
    };
    scalars("acoustic_energy", |event| event.energy)?;
    scalars("acoustic_magnitude", AcousticEvent::magnitude)?;
    scalars("acoustic_fracture_energy", |event| event.fracture_energy)?;
    scalars("acoustic_event_mode", |event| event.failure_mode)?;
    out.write_all(b"</PointData>\n")?;
    vtk_xml::close_point_cloud(out, events.iter().map(|event| single(event.position)))
}
