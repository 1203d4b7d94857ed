// Iso-surfaces within the solid: thin films that let light through, more of it straight on than aslant.

// Its layout is that of `FilmUniform` in shell.rs.
struct Film {
    // Seen straight on.
    opacity: f32,
    // Of the ramps' texture, from 0 to 1.
    @size(12) row: f32,
}

@group(3) @binding(0) var<uniform> film: Film;

const FILM_ROUGHNESS = 0.3;
// Light that the film gives off, as a factor on its color: what comes through it from behind.
const TRANSLUCENCY = 0.16;
// Cosine of the steepest angle that a film is seen at: beyond it the rim does not become denser.
const LEAST_COSINE = 0.1;
// Of the color that is left where the film is densest: nested rims stand out from one another.
const DEEPEST = 0.42;

struct ShellFragment {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) distance: f32,
}

@vertex
fn vs_shell(vertex: Vertex, @location(2) distance: f32) -> ShellFragment {
    return ShellFragment(to_clip(vertex.position), vertex.position, vertex.normal, distance);
}

@fragment
fn fs_shell(fragment: ShellFragment) -> @location(0) vec4f {
    let normal = normal_to_eye(fragment.position, fragment.normal).xyz;
    let cosine = max(dot(normal, normalize(frame.eye - fragment.position)), LEAST_COSINE);
    // Beer and Lambert: the way through a film is longer by the inverse of the cosine.
    let alpha = 1.0 - pow(1.0 - film.opacity, 1.0 / cosine);
    let slant = 1.0 - cosine;
    let color = ramp_color(fragment.distance, film.row) * mix(1.0, DEEPEST, slant * slant);
    let material = Material(color, 0.0, FILM_ROUGHNESS, TRANSLUCENCY * color, 1.0);
    return vec4f(encode(shade_open(material, fragment.position, normal, normal)).rgb * alpha, alpha);
}
