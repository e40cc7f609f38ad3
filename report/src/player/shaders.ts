// Particles as round dots of their size in the world, coloured from a table.

const SLICE = `
uniform vec3 boxMin;
uniform vec3 boxSize;
uniform vec3 sliceAxis;
uniform vec2 sliceRange;
uniform float dotSize;
uniform float pixelScale; // pixels of a length of one: in a flat view, in perspective at a distance of one
uniform float isFlat;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;

vec4 place(vec3 quantised) {
  vec3 point = boxMin + quantised * (65535.0 / 65534.0) * boxSize;
  float along = dot(sliceAxis, point);
  vec4 seen = modelViewMatrix * vec4(point, 1.0);
  float pixels = dotSize * pixelScale / mix(-seen.z, 1.0, isFlat);
  gl_PointSize = clamp(pixels, 1.5, 256.0);
  bool isNowhere = any(greaterThan(quantised, vec3(65534.5 / 65535.0)));
  bool isCut = isNowhere || along < sliceRange.x || along > sliceRange.y;
  return isCut ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * seen;
}
`;

export const PARTICLE_VERTEX = `
precision highp float;
precision highp int;
in vec4 quad;
${SLICE}
uniform sampler2D colours;
uniform vec2 range;       // of quantised values
uniform float isCategory;
uniform vec4 none;
out vec4 colour;

void main() {
  gl_Position = place(quad.xyz);
  float value = floor(quad.w * 65535.0 + 0.5);
  float share = clamp((value - range.x) / max(range.y - range.x, 1e-6), 0.0, 1.0);
  float column = mix(share * 255.0, value, isCategory);
  colour = texture(colours, vec2((column + 0.5) / 256.0, 0.5));
  if (value > 65534.5) colour = none;
  if (colour.a < 0.01) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
`;

/** The rounded look is for depth only: the middle of a dot has exactly the colour of the table. */
export const PARTICLE_FRAGMENT = `
precision highp float;
in vec4 colour;
uniform float isFlat;
out vec4 pixel;

void main() {
  vec2 from = 2.0 * gl_PointCoord - 1.0;
  float r = dot(from, from);
  if (r > 1.0) discard;
  float shade = mix(0.55 + 0.45 * sqrt(1.0 - r), 1.0, isFlat);
  pixel = vec4(colour.rgb * shade, 1.0);
}
`;

export const WALL_VERTEX = `
precision highp float;
in vec4 quad;
${SLICE}
void main() {
  gl_Position = place(quad.xyz);
}
`;

export const WALL_FRAGMENT = `
precision highp float;
uniform vec4 none;
uniform float isFlat;
out vec4 pixel;

void main() {
  vec2 from = 2.0 * gl_PointCoord - 1.0;
  if (dot(from, from) > 1.0) discard;
  pixel = vec4(none.rgb, mix(0.18, 0.8, isFlat));
}
`;
