// Descriptions taken from sdformat 12, Copyright 2012 Open Source Robotics Foundation, Apache License 2.0.
#include "sdf/schema/schema_table.hh"

namespace pongsim::sdf {

namespace {

using enum Use;

constexpr SchemaRow kCameraRows[] = {
    {"camera", "", "", '1', 0, 0, kRead, "These elements are specific to camera sensors."},
    {"camera@name", "string", "", '0', 3, 0, kRead, "An optional name for the camera."},
    {"camera.box_type", "string", "2d", '0', 9, 0, kRead,
     "The boundingbox type of the boundingbox camera. Valid options are: - 2d | visible_2d | visible_box_2d: a visible "
     "2d box mode which provides axis aligned 2d boxes on the visible parts of the objects - full_2d | full_box_2d: a "
     "full 2d box mode which provides axis aligned 2d boxes that fills the object dimentions, even if it has an "
     "occluded part - 3d: a 3d mode which provides oriented 3d boxes"},
    {"camera.camera_info_topic", "string", "", '0', 9, 0, kRead, "Name of the topic of the camera info."},
    {"camera.clip", "", "", '1', 0, 0, kRead,
     "The near and far clip planes. Objects closer or farther than these planes are not rendered."},
    {"camera.clip.far", "double", "100", '1', 2, 0, kRead, "Far clipping plane"},
    {"camera.clip.near", "double", ".1", '1', 2, 0, kRead, "Near clipping plane"},
    {"camera.depth_camera", "", "", '0', 0, 0, kRead, "Depth camera parameters"},
    {"camera.depth_camera.clip", "", "", '0', 6, 0, kRead,
     "The near and far clip planes. Objects closer or farther than these planes are not detected by the depth camera."},
    {"camera.depth_camera.clip.far", "double", "10.0", '0', 6, 0, kRead, "Far clipping plane for depth camera"},
    {"camera.depth_camera.clip.near", "double", ".1", '0', 6, 0, kRead, "Near clipping plane for depth camera"},
    {"camera.depth_camera.output", "string", "depths", '1', 2, 0, kRead, "Type of output"},
    {"camera.distortion", "", "", '0', 5, 0, kRead,
     "Lens distortion to be applied to camera images. See "
     "http://en.wikipedia.org/wiki/Distortion_(optics)#Software_correction"},
    {"camera.distortion.center", "vector2d", "0.5 0.5", '0', 5, 0, kRead, "The distortion center or principal point"},
    {"camera.distortion.k1", "double", "0.0", '0', 5, 0, kRead, "The radial distortion coefficient k1"},
    {"camera.distortion.k2", "double", "0.0", '0', 5, 0, kRead, "The radial distortion coefficient k2"},
    {"camera.distortion.k3", "double", "0.0", '0', 5, 0, kRead, "The radial distortion coefficient k3"},
    {"camera.distortion.p1", "double", "0.0", '0', 5, 0, kRead, "The tangential distortion coefficient p1"},
    {"camera.distortion.p2", "double", "0.0", '0', 5, 0, kRead, "The tangential distortion coefficient p2"},
    {"camera.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"camera.horizontal_fov", "double", "1.047", '1', 0, 0, kRead, "Horizontal field of view"},
    {"camera.image", "", "", '1', 0, 0, kRead, "The image size in pixels and format."},
    {"camera.image.anti_aliasing", "int", "4", '0', 9, 0, kRead, "Value used for anti-aliasing"},
    {"camera.image.format", "string", "R8G8B8", '0', 2, 0, kRead,
     "(L8|L16|R_FLOAT16|R_FLOAT32|R8G8B8|B8G8R8|BAYER_RGGB8|BAYER_BGGR8|BAYER_GBRG8|BAYER_GRBG8)"},
    {"camera.image.height", "int", "240", '1', 2, 0, kRead, "Height in pixels"},
    {"camera.image.width", "int", "320", '1', 2, 0, kRead, "Width in pixels"},
    {"camera.lens", "", "", '0', 5, 0, kRead, "Lens projection description"},
    {"camera.lens.custom_function", "", "", '0', 5, 0, kRead,
     "Definition of custom mapping function in a form of r=c1*f*fun(theta/c2 + c3). See "
     "https://en.wikipedia.org/wiki/Fisheye_lens#Mapping_function"},
    {"camera.lens.custom_function.c1", "double", "1", '0', 5, 0, kRead, "Linear scaling constant"},
    {"camera.lens.custom_function.c2", "double", "1", '0', 5, 0, kRead, "Angle scaling constant"},
    {"camera.lens.custom_function.c3", "double", "0", '0', 5, 0, kRead, "Angle offset constant"},
    {"camera.lens.custom_function.f", "double", "1", '0', 5, 0, kRead,
     "Focal length of the optical system. Note: It's not a focal length of the lens in a common sense! This value is "
     "ignored if 'scale_to_fov' is set to true"},
    {"camera.lens.custom_function.fun", "string", "tan", '1', 5, 0, kRead, "Possible values are 'sin', 'tan' and 'id'"},
    {"camera.lens.cutoff_angle", "double", "1.5707", '0', 5, 0, kRead,
     "Everything outside of the specified angle will be hidden, 90° by default"},
    {"camera.lens.env_texture_size", "int", "256", '0', 5, 0, kRead,
     "Resolution of the environment cube map used to draw the world"},
    {"camera.lens.intrinsics", "", "", '0', 6, 0, kRead,
     "Camera intrinsic parameters for setting a custom perspective projection matrix (cannot be used with "
     "WideAngleCamera since this class uses image stitching from 6 different cameras for achieving a wide field of "
     "view). The focal lengths can be computed using focal_length_in_pixels = (image_width_in_pixels * 0.5) / "
     "tan(field_of_view_in_degrees * 0.5 * PI/180)"},
    {"camera.lens.intrinsics.cx", "double", "160", '1', 6, 0, kRead, "X principal point (in pixels)"},
    {"camera.lens.intrinsics.cy", "double", "120", '1', 6, 0, kRead, "Y principal point (in pixels)"},
    {"camera.lens.intrinsics.fx", "double", "277", '1', 6, 0, kRead,
     "X focal length (in pixels, overrides horizontal_fov)"},
    {"camera.lens.intrinsics.fy", "double", "277", '1', 6, 0, kRead,
     "Y focal length (in pixels, overrides horizontal_fov)"},
    {"camera.lens.intrinsics.s", "double", "0.0", '1', 6, 0, kRead, "XY axis skew"},
    {"camera.lens.projection", "", "", '0', 9, 0, kRead,
     "Camera projection matrix P for overriding camera intrinsic matrix K values so that users can configure P "
     "independently of K. This is useful when working with stereo cameras where P may be different from K due to the "
     "transform between the two cameras."},
    {"camera.lens.projection.p_cx", "double", "160", '0', 9, 0, kRead,
     "X principal point for projection matrix (in pixels, overrides cx)"},
    {"camera.lens.projection.p_cy", "double", "120", '0', 9, 0, kRead,
     "Y principal point for projection matrix (in pixels, overrides cy)"},
    {"camera.lens.projection.p_fx", "double", "277", '0', 9, 0, kRead,
     "X focal length for projection matrix (in pixels, overrides fx)"},
    {"camera.lens.projection.p_fy", "double", "277", '0', 9, 0, kRead,
     "Y focal length for projection matrix (in pixels, overrides fy)"},
    {"camera.lens.projection.tx", "double", "0.0", '0', 9, 0, kRead, "X translation for projection matrix (in pixels)"},
    {"camera.lens.projection.ty", "double", "0.0", '0', 9, 0, kRead, "Y translation for projection matrix (in pixels)"},
    {"camera.lens.scale_to_hfov", "bool", "true", '1', 5, 0, kRead,
     "If true the image will be scaled to fit horizontal FOV, otherwise it will be shown according to projection type "
     "parameters"},
    {"camera.lens.type", "string", "stereographic", '1', 5, 0, kRead,
     "Type of the lens mapping. Supported values are gnomonical, stereographic, equidistant, equisolid_angle, "
     "orthographic, custom. For gnomonical (perspective) projection, it is recommended to specify a horizontal_fov of "
     "less than or equal to 90°"},
    {"camera.noise", "", "", '0', 4, 0, kRead,
     "The properties of the noise model that should be applied to generated images"},
    {"camera.noise.mean", "double", "0.0", '0', 4, 0, kRead,
     "For type \"gaussian,\" the mean of the Gaussian distribution from which noise values are drawn."},
    {"camera.noise.stddev", "double", "0.0", '0', 4, 0, kRead,
     "For type \"gaussian,\" the standard deviation of the Gaussian distribution from which noise values are drawn."},
    {"camera.noise.type", "string", "gaussian", '1', 4, 0, kRead,
     "The type of noise. Currently supported types are: \"gaussian\" (draw additive noise values independently for "
     "each pixel from a Gaussian distribution)."},
    {"camera.optical_frame_id", "string", "", '0', 9, 0, kRead,
     "An optional frame id name to be used in the camera_info message header."},
    {"camera.pose", "+pose", "", '0', 3, 0, kRead, ""},
    {"camera.save", "", "", '0', 0, 0, kRead, "Enable or disable saving of camera frames."},
    {"camera.save@enabled", "bool", "false", '1', 0, 0, kRead, "True = saving enabled"},
    {"camera.save.path", "string", "", '1', 2, 0, kRead,
     "The path name which will hold the frame data. If path name is relative, then directory is relative to current "
     "working directory."},
    {"camera.segmentation_type", "string", "semantic", '0', 9, 0, kRead,
     "The segmentation type of the segmentation camera. Valid options are: - semantic: Semantic segmentation, which "
     "provides 2 images: 1. A grayscale image, with the pixel values representing the label of an object 2. A colored "
     "image, with the pixel values being a unique color for each label - panoptic | instance: Panoptic segmentation, "
     "which provides an image where each pixel has 1 channel for label value of the object and 2 channels for the "
     "number of the instances of that label, and a colored image which its pixels have a unique color for each "
     "instance."},
    {"camera.trigger_topic", "string", "", '0', 9, 0, kRead,
     "Name of the topic that will trigger the camera if enabled"},
    {"camera.triggered", "bool", "false", '0', 9, 0, kRead, "If the camera will be triggered by a topic"},
    {"camera.visibility_mask", "unsigned int", "4294967295", '0', 7, 0, kRead,
     "Visibility mask of a camera. When (camera's visibility_mask & visual's visibility_flags) evaluates to non-zero, "
     "the visual will be visible to the camera."},
};

}  // namespace

std::span<const SchemaRow> cameraRows() { return kCameraRows; }

}  // namespace pongsim::sdf
