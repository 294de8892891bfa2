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
/// Metalness, roughness.
inline constexpr int kFinish = 7;
/// Viewing direction, unit vector.
inline constexpr int kAhead = 8;
/// Pinhole only: from a position in the image to a direction.
inline constexpr int kDirectionFromClip = 9;
inline constexpr int kZenith = 10;
inline constexpr int kHorizon = 11;
/// Whether there is a normal map.
inline constexpr int kHasNormals = 12;
/// How far the clouds have moved, cells per unit of height, share of the sky.
inline constexpr int kClouds = 13;
inline constexpr int kCloudColor = 14;

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
/// Needs what `surfaceFragment` puts in front of it: the processor executes both sides of a branch and looks up eight
/// lamps for eight pixels, so that each kind of surface, and each set of lamps, gets a program without either.
inline constexpr const char* kSurfaceFragment = R"(
const float kPi = 3.14159265;
struct Lamp {
  vec4 place;        // seen from the eye
  vec4 direction;    // where it shines
  vec4 diffuse;
  vec4 specular;     // w: range
  vec4 attenuation;  // constant, linear, quadratic; w: falloff
  vec4 cone;         // cosines of half the inner and the outer angle; z: edge of the shadow's pixels, of a spot's at 1 m
};
layout(std140, binding = 0) uniform Lamps {
  Lamp lamps[16];
  mat4 shadowFromPlace[4];
  vec4 surroundings;  // ambient light
  vec4 background;
  vec4 fog;       // colour; w: density
  vec4 fogPlace;  // where it begins, and 1 / its length
};
layout(location = 3) uniform vec4 diffuse;
layout(location = 4) uniform vec3 ambient;
layout(location = 5) uniform vec3 specular;
layout(location = 6) uniform vec3 emissive;
layout(location = 7) uniform vec2 finish;
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

float fifthPower(float x) { return x * x * (x * x) * x; }

// Share of a lamp's light that comes through to a place: the mean of three by three bilinear comparisons, which four by
// four pixels of the map make together.
float litShare(int shadow, vec3 point, vec3 normal, float pixel) {
  // a step off the surface, so that it does not shade itself
  vec4 there = shadowFromPlace[shadow] * vec4(point + normal * pixel * 3.0, 1);
  vec3 at = there.xyz / there.w;
  at.xy = at.xy * 0.5 + 0.5;
  bool isOutside = any(lessThan(at.xy, vec2(0))) || any(greaterThan(at.xy, vec2(1)));
  float edge = float(textureSize(shadows, 0).x), depth = clamp(at.z, 0.0, 1.0) - 0.0005;
  vec2 whole = floor(at.xy * edge - 0.5), part = at.xy * edge - 0.5 - whole;
  // midway between two by two pixels each: x is theirs at the lower left, then counter-clockwise, y up
  vec4 a = textureGather(shadows, vec3(whole / edge, shadow), depth);
  vec4 b = textureGather(shadows, vec3((whole + vec2(2, 0)) / edge, shadow), depth);
  vec4 c = textureGather(shadows, vec3((whole + vec2(0, 2)) / edge, shadow), depth);
  vec4 d = textureGather(shadows, vec3((whole + vec2(2, 2)) / edge, shadow), depth);
  vec4 rows = vec4(a.w, a.x, c.w, c.x) * (1.0 - part.x) + vec4(a.z, a.y, c.z, c.y) + vec4(b.w, b.x, d.w, d.x) +
              vec4(b.z, b.y, d.z, d.y) * part.x;
  float sum = rows.x * (1.0 - part.y) + rows.y + rows.z + rows.w * part.y;
  return isOutside ? 1.0 : sum / 9.0;
}

// A place on a surface, seen from the eye.
struct Spot {
  vec3 normal;
  vec3 toEye;
  vec3 dull;    // reflected evenly
  vec3 mirror;  // reflected at right angles
  float cosEye;
  float alpha;  // square of the roughness
  float metalness;
};

// Light of a lamp that a place reflects. All but the place and the lamp's number is known when the program is compiled.
vec3 reflected(Spot spot, int number, bool hasPlace, bool isSpot, int shadow) {
  Lamp lamp = lamps[number];
  vec3 toLamp = -lamp.direction.xyz;
  float share = 1.0, pixel = lamp.cone.z;
  if (hasPlace) {
    vec3 way = lamp.place.xyz - place;
    float far = length(way);
    toLamp = way / max(far, 1e-6);
    share = 1.0 / max(lamp.attenuation.x + lamp.attenuation.y * far + lamp.attenuation.z * far * far, 1e-3);
    if (far > lamp.specular.w) share = 0.0;
    if (isSpot) {
      float within = (dot(-toLamp, lamp.direction.xyz) - lamp.cone.y) / max(lamp.cone.x - lamp.cone.y, 1e-5);
      share = within > 0.0 ? share * pow(min(within, 1.0), max(lamp.attenuation.w, 1e-3)) : 0.0;
      pixel *= far;
    }
  }
  float cosLamp = max(dot(spot.normal, toLamp), 0.0);
  if (shadow >= 0) share *= litShare(shadow, place, spot.normal, pixel);
  vec3 between = toLamp + spot.toEye;
  between *= inversesqrt(max(dot(between, between), 1e-12));
  float alpha2 = spot.alpha * spot.alpha, k = spot.alpha * 0.5;
  float cosBetween = max(dot(spot.normal, between), 0.0), round = cosBetween * cosBetween * (alpha2 - 1.0) + 1.0;
  // spread times visibility times pi
  float lobe = 0.25 * alpha2 / (round * round * ((cosLamp * (1.0 - k) + k) * (spot.cosEye * (1.0 - k) + k)));
  vec3 fresnel = spot.mirror + (1.0 - spot.mirror) * fifthPower(1.0 - max(dot(between, spot.toEye), 0.0));
  // a lamp's colour is what a white surface shows that faces it, which takes pi into account
  return share * cosLamp * (spot.dull * lamp.diffuse.rgb + fresnel * lobe *
                            mix(lamp.specular.rgb * specular, lamp.diffuse.rgb, spot.metalness));
}

void main() {
  vec3 base = diffuse.rgb, inShade = ambient, shine = emissive, sum;
  float opacity = diffuse.a;
#ifdef TEXTURED
  vec4 painted = texture(picture, texel);
  base *= painted.rgb;
  inShade *= painted.rgb;
  opacity *= painted.a;
#endif
#ifdef MAPPED
  shine *= texture(glow, texel).rgb;
#endif
#ifndef LIT
  sum = base + shine;
#else
  float metalness = finish.x, rough = finish.y;
  vec3 normal = normalize(facing) * (gl_FrontFacing ? 1.0 : -1.0), toEye = normalize(-place);
#ifdef MAPPED
  metalness *= texture(metalnesses, texel).r;
  rough *= texture(roughnesses, texel).r;
  if (hasNormals != 0) normal = toldNormal(normal);
#endif
  rough = max(rough, 0.06);
  float cosEye = max(dot(normal, toEye), 1e-3);
  vec3 mirror = mix(0.04 * specular, base, metalness);
  Spot spot = Spot(normal, toEye, base * (1.0 - metalness), mirror, cosEye, rough * rough, metalness);
  sum = shine + surroundings.rgb * inShade * (1.0 - metalness);
  float up = reflect(-toEye, normal).z * 0.5 + 0.5;
  vec3 mirrored = mix(surroundings.rgb * 0.5, background.rgb, smoothstep(0.35, 0.65, up));
  vec3 edge = mirror + (max(vec3(1.0 - rough), mirror) - mirror) * fifthPower(1.0 - cosEye);
  sum += edge * mirrored * mix(1.0, 0.4, rough);
  LAMPS
#endif
#ifdef FOG
  float far = length(place);
  sum = mix(fog.rgb, sum, FOG);
#endif
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

/// Markers: one colour, whatever light there is.
inline constexpr const char* kMarkerFragment = R"(#version 450 core
layout(location = 3) uniform vec4 tint;
out vec4 color;
void main() { color = tint; }
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

/// A clear sky, and clouds in a plane above it: noise of four octaves (Perlin 1985), of values at the corners of cells.
inline constexpr const char* kSkyFragment = R"(#version 450 core
layout(location = 10) uniform vec3 zenith;
layout(location = 11) uniform vec3 horizon;
layout(location = 13) uniform vec4 clouds;
layout(location = 14) uniform vec3 cloudColor;
in vec3 direction;
out vec4 color;
// a number for each cell, 0 to 1
float valueAt(ivec2 cell) {
  uint bits = uint(cell.x) * 0x8DA6B343u ^ uint(cell.y) * 0xD8163841u;
  bits = (bits ^ (bits >> 13)) * 0x5BD1E995u;
  return float((bits ^ (bits >> 15)) & 0xFFFFu) / 65535.0;
}
float noiseAt(vec2 at) {
  ivec2 cell = ivec2(floor(at));
  vec2 part = fract(at), share = part * part * (3.0 - 2.0 * part);
  return mix(mix(valueAt(cell), valueAt(cell + ivec2(1, 0)), share.x),
             mix(valueAt(cell + ivec2(0, 1)), valueAt(cell + ivec2(1, 1)), share.x), share.y);
}
void main() {
  vec3 d = normalize(direction);
  vec3 clear = mix(horizon, zenith, pow(max(d.z, 0.0), 0.5));
  vec2 at = (d.xy / max(d.z, 0.02) - clouds.xy) * clouds.z;
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) sum += noiseAt(at * float(1 << i) + float(17 * i)) * 0.5 / float(1 << i);
  float density = smoothstep(1.0 - clouds.w, 1.3 - clouds.w, sum / 0.9375) * smoothstep(0.02, 0.2, d.z);
  color = vec4(mix(clear, cloudColor, density), 1);
}
)";

/// Makes one colour of the four samples of each pixel, as linear light.
inline constexpr const char* kResolveVertex = R"(#version 450 core
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0, 1);
}
)";

inline constexpr const char* kResolveFragment = R"(#version 450 core
layout(binding = 0) uniform sampler2DMS samples;
out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  color = (texelFetch(samples, at, 0) + texelFetch(samples, at, 1) + texelFetch(samples, at, 2) +
           texelFetch(samples, at, 3)) * 0.25;
}
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
