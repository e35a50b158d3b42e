#pragma once

/// What a surface reflects of a light without size. Private to the libraries.

#include "gnomon/light.h"
#include "shading/reflection/reflection_query.h"

namespace gnomon::shading {

/// Of a visible point light of intensity 1: the integrand itself. Infinite at the light.
Reflection point_reflection(const PointLight& light, const ReflectionQuery& query);

/// Of a visible directional light of which a surface across it receives 1.
Reflection directional_reflection(const DirectionalLight& light, const ReflectionQuery& query);

}  // namespace gnomon::shading
