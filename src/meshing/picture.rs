//! Pictures of meshes.

use super::{Generated, SpatialGenerated};
use ypsilon_post::{
    PostError,
    field::Field,
    plot::{ContourOptions, JointLines, Picture, Solid, SolidOptions, contour, solid},
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
        elements: mesh.triangles.iter().map(|t| t.nodes.map(|n| number(n) as u32)).collect(),
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

/// Draws tetrahedra as they are seen from the front, coloured by their blocks.
///
/// # Errors
/// If the width makes no sense.
pub fn picture_in_space(generated: &SpatialGenerated, width: u32) -> Result<Picture, PostError> {
    let mesh = &generated.model.mesh;
    // neighbours' numbers are close: a factor that shares nothing with small numbers parts them
    let value = |block: usize| (block * 5 % 11) as f64;
    let shown = Solid {
        points: mesh.nodes.clone(),
        tetrahedra: mesh.tetrahedra.iter().map(|t| t.nodes).collect(),
        values: mesh.tetrahedra.iter().map(|t| value(t.block)).collect(),
    };
    let options = SolidOptions {
        title: generated.model.title.clone(),
        quantity: "block × 5 modulo 11".to_owned(),
        unit: String::new(),
        range: None,
        from_deg: [-25.0, 20.0],
        width,
    };
    solid(&shown, &options)
}
