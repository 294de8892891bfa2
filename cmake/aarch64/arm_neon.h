// Eigen's products on aarch64 without fused multiplications and additions, which would give other bits than x86-64:
// it takes them as intrinsic functions, so that -ffp-contract=off does not help.
#pragma once

#include_next <arm_neon.h>

#define vfma_f32(c, a, b) vadd_f32(c, vmul_f32(a, b))
#define vfmaq_f32(c, a, b) vaddq_f32(c, vmulq_f32(a, b))
#define vfmaq_n_f32(c, a, b) vaddq_f32(c, vmulq_n_f32(a, b))
#define vfmaq_laneq_f32(c, a, b, lane) vaddq_f32(c, vmulq_laneq_f32(a, b, lane))
#define vfmaq_f64(c, a, b) vaddq_f64(c, vmulq_f64(a, b))
#define vfmaq_n_f64(c, a, b) vaddq_f64(c, vmulq_n_f64(a, b))
#define vfmaq_laneq_f64(c, a, b, lane) vaddq_f64(c, vmulq_laneq_f64(a, b, lane))
