use crate::{
    output::bodies::DisjointSets,
    simulation::{JointCondition, SpatialSimulation, face_joint_views},
};

/// Body number of each element (0, 1, ... by lowest element number); −1 for elements that are no
/// tetrahedra. A body hangs together through shared nodes or live joints.
#[must_use]
pub fn body_of_tetrahedra(simulation: &SpatialSimulation) -> Vec<i32> {
    let scene = simulation.scene();
    let mut sets = DisjointSets::new(scene.nodes.len());
    let tetrahedra: Vec<usize> = simulation.tetrahedra().collect();
    for &element in &tetrahedra {
        let [first, others @ ..] = scene.elements.corners::<4>(element);
        for other in others {
            sets.join(first, other);
        }
    }
    for joint in face_joint_views(simulation).filter(|j| j.condition != JointCondition::Broken) {
        for i in 0..3 {
            sets.join(joint.nodes[i], joint.nodes[i + 3]);
        }
    }
    let mut number_of_root = vec![-1; scene.nodes.len()];
    let mut bodies = vec![-1; scene.elements.len()];
    let mut count = 0;
    for &element in &tetrahedra {
        let number = &mut number_of_root[sets.root(scene.elements.corners::<4>(element)[0])];
        if *number < 0 {
            *number = count;
            count += 1;
        }
        bodies[element] = *number;
    }
    bodies
}
