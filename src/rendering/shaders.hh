#pragma once

namespace pongsim::rendering::shaders {

// Locations of the uniforms in the shader sources.
inline constexpr int kPlaceFromSurface = 0;
inline constexpr int kClipFromPlace = 1;
inline constexpr int kNormalFromSurface = 2;
inline constexpr int kDiffuse = 3;
inline constexpr int kAmbient = 4;
inline constexpr int kSpecular = 5;
inline constexpr int kEmissive = 6;
/// Metalness, roughness, whether it is lit, whether there is a texture.
inline constexpr int kFinish = 7;
/// Viewing direction, unit vector.
inline constexpr int kAhead = 8;
/// Pinhole only: from a position in the image to a direction.
inline constexpr int kDirectionFromClip = 9;
inline constexpr int kZenith = 10;
inline constexpr int kHorizon = 11;
/// Whether there is a normal map.
inline constexpr int kHasNormals = 12;

inline constexpr int kMostLamps = 16;
inline constexpr int kMostShadows = 4;

/// Surfaces. Positions are relative to the camera, along the world's axes, which keeps single precision accurate
/// wherever in the world the camera is.
inline constexpr const char* kSurfaceVertex = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 coordinates;
layout(location = 0) uniform mat4 placeFromSurface;
layout(location = 1) uniform mat4 clipFromPlace;
layout(location = 2) uniform mat3 normalFromSurface;
out vec3 place;
out vec3 facing;
out vec2 texel;
void main() {
  vec4 here = placeFromSurface * vec4(position, 1);
  place = here.xyz;
  facing = normalFromSurface * normal;
  texel = coordinates;
  gl_Position = clipFromPlace * here;
}
)";

/// Lighting: Lambert's law for the diffuse part; for highlights the distribution of Trowbridge and Reitz (GGX), with
/// Smith's visibility and Schlick's approximation of the Fresnel term (Walter et al. 2007, Karis 2013). Reflections of
/// the surroundings in smooth surfaces are approximated by the ambient light and the background.
///
/// Starts with `kPlain` or `kMapped`: most surfaces have no texture other than their colour, and get a program of their
/// own, because the processor executes both sides of a branch.
inline constexpr const char* kPlain = "#version 450 core\n";
inline constexpr const char* kMapped = "#version 450 core\n#define MAPPED\n";
inline constexpr const char* kSurfaceFragment = R"(
const float kPi = 3.14159265;
struct Lamp {
  vec4 place;        // seen from the eye; w: 0 for a lamp without a place, whose light comes from all over the sky
  vec4 direction;    // where it shines; w: 1 for a spot
  vec4 diffuse;      // w: number of its shadow, or -1
  vec4 specular;     // w: range
  vec4 attenuation;  // constant, linear, quadratic; w: falloff
  vec4 cone;         // cosines of half the inner and the outer angle; z: edge of the shadow's pixels, of a spot's at 1 m
};
layout(std140, binding = 0) uniform Lamps {
  Lamp lamps[16];
  mat4 shadowFromPlace[4];
  vec4 surroundings;  // ambient light; w: number of lamps
  vec4 background;
};
layout(location = 3) uniform vec4 diffuse;
layout(location = 4) uniform vec3 ambient;
layout(location = 5) uniform vec3 specular;
layout(location = 6) uniform vec3 emissive;
layout(location = 7) uniform vec4 finish;
layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) uniform sampler2DArrayShadow shadows;
in vec3 place;
in vec3 facing;
in vec2 texel;
out vec4 color;
#ifdef MAPPED
layout(location = 12) uniform int hasNormals;
layout(binding = 2) uniform sampler2D normals;
layout(binding = 3) uniform sampler2D roughnesses;
layout(binding = 4) uniform sampler2D metalnesses;
layout(binding = 5) uniform sampler2D glow;

// The normal that a map tells. How the map lies on the surface is told by how place and texel change from pixel to
// pixel (Schueler, Normal mapping without precomputed tangents, ShaderX5, 2006).
vec3 toldNormal(vec3 normal) {
  vec3 placeX = dFdx(place), placeY = dFdy(place);
  vec2 texelX = dFdx(texel), texelY = dFdy(texel);
  vec3 alongX = cross(placeY, normal), alongY = cross(normal, placeX);
  // the picture may be mirrored
  float side = sign(dot(cross(placeX, placeY), normal));
  vec3 right = side * (alongX * texelX.x + alongY * texelY.x);
  vec3 down = side * (alongX * texelX.y + alongY * texelY.y);
  float longest = max(dot(right, right), dot(down, down));
  if (!(longest > 0.0)) return normal;
  vec3 told = texture(normals, texel).xyz * 2.0 - 1.0;
  return normalize(normal * told.z + (right * told.x - down * told.y) * inversesqrt(longest));
}
#endif

// share of a lamp's light that comes through to a place
float litShare(int shadow, vec3 point, vec3 normal, float pixel) {
  // a step off the surface, so that it does not shade itself
  vec4 there = shadowFromPlace[shadow] * vec4(point + normal * pixel * 3.0, 1);
  vec3 at = there.xyz / there.w;
  at.xy = at.xy * 0.5 + 0.5;
  if (any(lessThan(at.xy, vec2(0))) || any(greaterThan(at.xy, vec2(1)))) return 1.0;
  at.z = clamp(at.z, 0.0, 1.0);
  float size = 1.0 / float(textureSize(shadows, 0).x), sum = 0.0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      sum += texture(shadows, vec4(at.xy + vec2(x, y) * size, float(shadow), at.z - 0.0005));
    }
  }
  return sum / 9.0;
}

void main() {
  vec3 base = diffuse.rgb, inShade = ambient;
  float opacity = diffuse.a;
  if (finish.w > 0.0) {
    vec4 painted = texture(picture, texel);
    base *= painted.rgb;
    inShade *= painted.rgb;
    opacity *= painted.a;
  }
  vec3 shine = emissive;
  float metalness = finish.x, rough = finish.y;
  vec3 normal = normalize(facing) * (gl_FrontFacing ? 1.0 : -1.0), toEye = normalize(-place);
#ifdef MAPPED
  shine *= texture(glow, texel).rgb;
  metalness *= texture(metalnesses, texel).r;
  rough *= texture(roughnesses, texel).r;
  if (hasNormals != 0) normal = toldNormal(normal);
#endif
  if (finish.z == 0.0) {
    color = vec4(base + shine, opacity);
    return;
  }
  rough = max(rough, 0.06);
  float alpha = rough * rough, alpha2 = alpha * alpha;
  float cosEye = max(dot(normal, toEye), 1e-3);
  vec3 mirror = mix(0.04 * specular, base, metalness), dull = base * (1.0 - metalness);
  vec3 sum = shine + surroundings.rgb * inShade * (1.0 - metalness);
  float up = reflect(-toEye, normal).z * 0.5 + 0.5;
  vec3 mirrored = mix(surroundings.rgb * 0.5, background.rgb, smoothstep(0.35, 0.65, up));
  vec3 edge = mirror + (max(vec3(1.0 - rough), mirror) - mirror) * pow(1.0 - cosEye, 5.0);
  sum += edge * mirrored * mix(1.0, 0.4, rough);
  for (int i = 0; i < int(surroundings.w); ++i) {
    Lamp lamp = lamps[i];
    vec3 toLamp = -lamp.direction.xyz;
    float share = 1.0, pixel = lamp.cone.z;
    if (lamp.place.w > 0.0) {
      vec3 way = lamp.place.xyz - place;
      float far = length(way);
      if (far > lamp.specular.w) continue;
      toLamp = way / max(far, 1e-6);
      share = 1.0 / max(lamp.attenuation.x + lamp.attenuation.y * far + lamp.attenuation.z * far * far, 1e-3);
      if (lamp.direction.w > 0.0) {
        float within = (dot(-toLamp, lamp.direction.xyz) - lamp.cone.y) / max(lamp.cone.x - lamp.cone.y, 1e-5);
        if (within <= 0.0) continue;
        share *= pow(min(within, 1.0), max(lamp.attenuation.w, 1e-3));
        pixel *= far;
      }
    }
    float cosLamp = dot(normal, toLamp);
    if (cosLamp <= 0.0) continue;
    if (lamp.diffuse.w >= 0.0) share *= litShare(int(lamp.diffuse.w), place, normal, pixel);
    if (share <= 0.0) continue;
    vec3 between = normalize(toLamp + toEye);
    float cosBetween = max(dot(normal, between), 0.0), round = cosBetween * cosBetween * (alpha2 - 1.0) + 1.0;
    float spread = alpha2 / (kPi * round * round), k = alpha * 0.5;
    float visibility = 0.25 / ((cosLamp * (1.0 - k) + k) * (cosEye * (1.0 - k) + k));
    vec3 fresnel = mirror + (1.0 - mirror) * pow(1.0 - max(dot(between, toEye), 0.0), 5.0);
    // a lamp's colour is what a white surface shows that faces it, which takes pi into account
    sum += share * cosLamp * (dull * lamp.diffuse.rgb + kPi * fresnel * spread * visibility *
                              mix(lamp.specular.rgb * specular, lamp.diffuse.rgb, metalness));
  }
  color = vec4(sum, opacity);
}
)";

/// Distance of a surface along the viewing direction.
inline constexpr const char* kDepthFragment = R"(#version 450 core
layout(location = 8) uniform vec3 ahead;
in vec3 place;
out float depth;
void main() { depth = dot(place, ahead); }
)";

inline constexpr const char* kShadowFragment = R"(#version 450 core
void main() {}
)";

/// The sky: one triangle that covers the image.
inline constexpr const char* kSkyVertex = R"(#version 450 core
layout(location = 9) uniform mat3 directionFromClip;
out vec3 direction;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  direction = directionFromClip * vec3(corner, 1);
  gl_Position = vec4(corner, 0, 1);
}
)";

inline constexpr const char* kSkyFragment = R"(#version 450 core
layout(location = 10) uniform vec3 zenith;
layout(location = 11) uniform vec3 horizon;
in vec3 direction;
out vec4 color;
void main() { color = vec4(mix(horizon, zenith, pow(max(normalize(direction).z, 0.0), 0.5)), 1); }
)";

/// Lines of one colour each.
inline constexpr const char* kLineVertex = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 tint;
layout(location = 1) uniform mat4 clipFromPlace;
out vec3 shade;
void main() {
  shade = tint;
  gl_Position = clipFromPlace * vec4(position, 1);
}
)";

inline constexpr const char* kLineFragment = R"(#version 450 core
in vec3 shade;
out vec4 color;
void main() { color = vec4(shade, 1); }
)";

}  // namespace pongsim::rendering::shaders
