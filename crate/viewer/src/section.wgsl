// The section that closes a cut, with the same pattern as the surface. It lies open, though it is inside of the solid.

fn lit_open(painted: Painted, position: vec3f) -> vec4f {
    let light = shade_open(painted.material, position, painted.normal, painted.geometric.xyz);
    return outlined(encode(light), painted.outline);
}

@fragment
fn fs_section(fragment: Fragment) -> @location(0) vec4f {
    return lit_open(paint_field(fragment), fragment.position);
}

@fragment
fn fs_section_plain(fragment: Fragment) -> @location(0) vec4f {
    return lit_open(paint_plain(fragment), fragment.position);
}
