//! Pictures of meshes.

use super::Generated;
use ypsilon_post::{
    PostError,
    field::Field,
    plot::{ContourOptions, JointLines, Picture, contour},
    results::Frame,
};

/// Draws the triangles, coloured by their property set, in a picture so many pixels wide.
///
/// # Errors
/// If the width makes no sense.
pub fn picture(generated: &Generated, width: u32) -> Result<Picture, PostError> {
    let mesh = &generated.model.mesh;
    let number = |n: usize| i32::try_from(n).unwrap_or(i32::MAX);
    let frame = Frame {
        points: mesh.nodes.clone(),
        triangles: mesh.triangles.iter().map(|t| t.nodes.map(|n| number(n) as u32)).collect(),
        property: generated.properties.of_triangle.iter().map(|&set| number(set)).collect(),
        ..Frame::default()
    };
    let options = ContourOptions {
        edges: true,
        joints: JointLines::None,
        title: Some(generated.model.title.clone()),
        width,
        ..ContourOptions::new(Field::Material)
    };
    contour(&frame, &options)
}
