//! Damping that is critical for the lowest frequency in motion.

use super::free_nodes::FreeNodes;
use crate::mechanics::Vec2;

/// Estimates the frequency of the present motion with the Rayleigh quotient of the incremental
/// stiffness: ω² = vᵀ K v / vᵀ M v, where K v Δt is the change of the internal forces in the last
/// step (Underwood 1983; Joldes, Wittek and Miller 2011).
#[derive(Debug, Clone, Default)]
pub(super) struct FrequencyEstimate {
    /// Resisting forces of the last iteration, N.
    before: Vec<Vec2>,
}

impl FrequencyEstimate {
    /// Takes in the resisting forces of this iteration, N; gives the critical damping coefficient
    /// 2 ω, 1/s. `velocities` are those that led here, `masses` the fictitious ones.
    pub fn critical_damping(
        &mut self,
        free: &FreeNodes,
        velocities: &[Vec2],
        masses: &[f64],
        resisting: &[Vec2],
        dt: f64,
    ) -> f64 {
        let (mut power, mut kinetic) = (0.0, 0.0);
        if self.before.len() == resisting.len() {
            for (k, free) in free.list.iter().enumerate() {
                let v = velocities[free.node as usize];
                power -= v.dot(&(resisting[k] - self.before[k]));
                kinetic += masses[k] * v.norm_squared();
            }
        }
        self.before.clear();
        self.before.extend_from_slice(resisting);
        if power > 0.0 && kinetic > 0.0 { 2.0 * (power / (kinetic * dt)).sqrt() } else { 0.0 }
    }
}
