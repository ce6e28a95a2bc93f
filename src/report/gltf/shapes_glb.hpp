#pragma once
#include <string>

#include "pipeline/survey.hpp"
#include "report/svg/wireframe.hpp"

namespace percuss::report {

/// Mode shapes as a binary glTF 2.0 file, which 3-D viewers and Blender animate. Each mode has two nodes: the
/// deflected structure in the colours of the page, and its lines at rest in grey. Two morph targets hold the real part
/// and the negative imaginary part of the shape φ, scaled for display. An animation per mode moves their weights as cos
/// ωt and sin ωt, so that the structure moves as Re(φ e^{jωt}), slowed down to two seconds per cycle. Nodes are named
/// after their modes; the `extras` of the deflected structure have frequency_hz, damping_ratio and displacement_scale
/// (drawn metres at the largest deflection). z of the survey is up.
/// errors  InputError: no modes, or fewer than two points with coordinates.
std::string shapes_glb(const pipeline::Survey& survey);

/// The same for a frame with at least two points and one mode.
std::string frame_glb(const Wireframe& frame);

}  // namespace percuss::report
