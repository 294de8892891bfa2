// Descriptions taken from sdformat 12, Copyright 2012 Open Source Robotics Foundation, Apache License 2.0.
#include "sdf/schema/schema_table.hh"

namespace pongsim::sdf {

namespace {

using enum Use;

constexpr SchemaRow kShapeRows[] = {
    {"box", "", "", '1', 4, 0, kRead, "Box shape"},
    {"box.size", "vector3", "1 1 1", '1', 2, 0, kRead,
     "The three side lengths of the box. The origin of the box is in its geometric center (inside the center of the "
     "box)."},
    {"capsule", "", "", '1', 8, 0, kRead, "Capsule shape"},
    {"capsule.length", "double", "1", '1', 8, 0, kRead,
     "Length of the cylindrical portion of the capsule along the z axis"},
    {"capsule.radius", "double", "0.5", '1', 8, 0, kRead, "Radius of the capsule"},
    {"collision", "", "", '1', 0, 0, kRead,
     "The collision properties of a link. Note that this can be different from the visual properties of a link, for "
     "example, simpler collision models are often used to reduce computation time."},
    {"collision@name", "string", "", '1', 0, 0, kRead,
     "Unique name for the collision element within the scope of the parent link."},
    {"collision.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"collision.geometry", "+geometry", "", '1', 0, 0, kRead, ""},
    {"collision.laser_retro", "double", "0", '0', 2, 0, kPassed, "intensity value returned by laser sensor."},
    {"collision.max_contacts", "int", "10", '0', 0, 0, kRead,
     "Maximum number of contacts allowed between two entities. This value overrides the max_contacts element defined "
     "in physics."},
    {"collision.pose", "+pose", "", '0', 2, 0, kRead, ""},
    {"collision.surface", "+surface", "", '0', 0, 0, kRead, ""},
    {"cylinder", "", "", '1', 4, 0, kRead, "Cylinder shape"},
    {"cylinder.length", "double", "1", '1', 2, 0, kRead, "Length of the cylinder along the z axis"},
    {"cylinder.radius", "double", "1", '1', 2, 0, kRead, "Radius of the cylinder"},
    {"ellipsoid", "", "", '1', 8, 0, kRead, "Ellipsoid shape"},
    {"ellipsoid.radii", "vector3", "1 1 1", '1', 8, 0, kRead,
     "The three radii of the ellipsoid. The origin of the ellipsoid is in its geometric center (inside the center of "
     "the ellipsoid)."},
    {"geometry", "", "", '1', 0, 0, kRead, "The shape of the visual or collision object."},
    {"geometry.box", "+box", "", '0', 0, 0, kRead, ""},
    {"geometry.capsule", "+capsule", "", '0', 8, 0, kRead, ""},
    {"geometry.cylinder", "+cylinder", "", '0', 0, 0, kRead, ""},
    {"geometry.ellipsoid", "+ellipsoid", "", '0', 8, 0, kRead, ""},
    {"geometry.empty", "", "", '0', 3, 0, kRead, "You can use the empty tag to make empty geometries."},
    {"geometry.heightmap", "+heightmap", "", '0', 0, 0, kRead, ""},
    {"geometry.image", "+image", "", '0', 0, 0, kRead, ""},
    {"geometry.mesh", "+mesh", "", '0', 0, 0, kRead, ""},
    {"geometry.plane", "+plane", "", '0', 0, 0, kRead, ""},
    {"geometry.polyline", "+polyline", "", '0', 5, 0, kRead, ""},
    {"geometry.sphere", "+sphere", "", '0', 0, 0, kRead, ""},
    {"heightmap", "", "", '1', 4, 0, kRead, "A heightmap based on a 2d grayscale image."},
    {"heightmap.blend", "", "", '*', 0, 0, kRead,
     "The blend tag controls how two adjacent textures are mixed. The number of blend elements should equal one less "
     "than the number of textures."},
    {"heightmap.blend.fade_dist", "double", "0", '1', 0, 0, kRead, "Distance over which the blend occurs"},
    {"heightmap.blend.min_height", "double", "0", '1', 0, 0, kRead, "Min height of a blend layer"},
    {"heightmap.pos", "vector3", "0 0 0", '0', 2, 0, kRead, "A position offset."},
    {"heightmap.sampling", "unsigned int", "1", '0', 6, 0, kRead,
     "Samples per heightmap datum. For rasterized heightmaps, this indicates the number of samples to take per pixel. "
     "Using a higher value, e.g. 2, will generally improve the quality of the heightmap but lower performance."},
    {"heightmap.size", "vector3", "1 1 1", '0', 2, 0, kRead,
     "The size of the heightmap in world units. When loading an image: \"size\" is used if present, otherwise defaults "
     "to 1x1x1. When loading a DEM: \"size\" is used if present, otherwise defaults to true size of DEM."},
    {"heightmap.texture", "", "", '*', 0, 0, kRead,
     "The heightmap can contain multiple textures. The order of the texture matters. The first texture will appear at "
     "the lowest height, and the last texture at the highest height. Use blend to control the height thresholds and "
     "fade between textures."},
    {"heightmap.texture.diffuse", "string", "", '1', 0, 0, kRead, "Diffuse texture image filename"},
    {"heightmap.texture.normal", "string", "", '1', 0, 0, kRead, "Normalmap texture image filename"},
    {"heightmap.texture.size", "double", "10", '1', 0, 0, kRead, "Size of the applied texture in meters."},
    {"heightmap.uri", "string", "", '1', 2, 0, kRead, "URI to a grayscale image file"},
    {"heightmap.use_terrain_paging", "bool", "false", '0', 4, 0, kRead,
     "Set if the rendering engine will use terrain paging"},
    {"image", "", "", '1', 4, 0, kRead, "Extrude a set of boxes from a grayscale image."},
    {"image.granularity", "int", "1", '1', 2, 0, kRead, "The amount of error in the model"},
    {"image.height", "double", "1", '1', 2, 0, kRead, "Height of the extruded boxes"},
    {"image.scale", "double", "1", '1', 2, 0, kRead, "Scaling factor applied to the image"},
    {"image.threshold", "int", "200", '1', 2, 0, kRead, "Grayscale threshold"},
    {"image.uri", "string", "", '1', 2, 0, kRead, "URI of the grayscale image file"},
    {"material", "", "", '1', 5, 0, kRead, "The material of the visual element."},
    {"material.ambient", "color", "0 0 0 1", '0', 0, 0, kRead,
     "The ambient color of a material specified by set of four numbers representing red/green/blue, each in the range "
     "of [0,1]."},
    {"material.diffuse", "color", "0 0 0 1", '0', 0, 0, kRead,
     "The diffuse color of a material specified by set of four numbers representing red/green/blue/alpha, each in the "
     "range of [0,1]."},
    {"material.double_sided", "bool", "false", '0', 7, 0, kRead,
     "If true, the mesh that this material is applied to will be rendered as double sided"},
    {"material.emissive", "color", "0 0 0 1", '0', 0, 0, kRead,
     "The emissive color of a material specified by set of four numbers representing red/green/blue, each in the range "
     "of [0,1]."},
    {"material.lighting", "bool", "true", '0', 4, 0, kRead, "If false, dynamic lighting will be disabled"},
    {"material.pbr", "", "", '0', 6, 0, kRead,
     "Physically Based Rendering (PBR) material. There are two PBR workflows: metal and specular. While both workflows "
     "and their parameters can be specified at the same time, typically only one of them will be used (depending on "
     "the underlying renderer capability). It is also recommended to use the same workflow for all materials in the "
     "world."},
    {"material.pbr.metal", "", "", '0', 6, 0, kRead, "PBR using the Metallic/Roughness workflow."},
    {"material.pbr.metal.albedo_map", "string", "", '0', 6, 0, kRead, "Filename of the diffuse/albedo map."},
    {"material.pbr.metal.ambient_occlusion_map", "string", "", '0', 6, 0, kRead,
     "Filename of the ambient occlusion map. The map defines the amount of ambient lighting on the surface."},
    {"material.pbr.metal.emissive_map", "string", "", '0', 6, 0, kRead, "Filename of the emissive map."},
    {"material.pbr.metal.environment_map", "string", "", '0', 6, 0, kRead,
     "Filename of the environment / reflection map, typically in the form of a cubemap"},
    {"material.pbr.metal.light_map", "string", "", '0', 7, 0, kRead,
     "Filename of the light map. The light map is a prebaked light texture that is applied over the albedo map"},
    {"material.pbr.metal.light_map@uv_set", "unsigned int", "0", '0', 7, 0, kRead,
     "Index of the texture coordinate set to use."},
    {"material.pbr.metal.metalness", "string", "0.5", '0', 6, 0, kRead,
     "Material metalness in the range of [0,1], where 0 represents non-metal and 1 represents raw metal"},
    {"material.pbr.metal.metalness_map", "string", "", '0', 6, 0, kRead, "Filename of the metalness map."},
    {"material.pbr.metal.normal_map", "string", "", '0', 6, 0, kRead,
     "Filename of the normal map. The normals can be in the object space or tangent space as specified in the 'type' "
     "attribute"},
    {"material.pbr.metal.normal_map@type", "string", "tangent", '0', 6, 0, kRead,
     "The space that the normals are in. Values are: 'object' or 'tangent'"},
    {"material.pbr.metal.roughness", "string", "0.5", '0', 6, 0, kRead,
     "Material roughness in the range of [0,1], where 0 represents a smooth surface and 1 represents a rough surface. "
     "This is the inverse of a specular map in a PBR specular workflow."},
    {"material.pbr.metal.roughness_map", "string", "", '0', 6, 0, kRead, "Filename of the roughness map."},
    {"material.pbr.specular", "", "", '0', 6, 0, kRead, "PBR using the Specular/Glossiness workflow."},
    {"material.pbr.specular.albedo_map", "string", "", '0', 6, 0, kRead, "Filename of the diffuse/albedo map."},
    {"material.pbr.specular.ambient_occlusion_map", "string", "", '0', 6, 0, kRead,
     "Filename of the ambient occlusion map. The map defines the amount of ambient lighting on the surface."},
    {"material.pbr.specular.emissive_map", "string", "", '0', 6, 0, kRead, "Filename of the emissive map."},
    {"material.pbr.specular.environment_map", "string", "", '0', 6, 0, kRead,
     "Filename of the environment / reflection map, typically in the form of a cubemap"},
    {"material.pbr.specular.glossiness", "string", "0", '0', 6, 0, kRead,
     "Material glossiness in the range of [0-1], where 0 represents a rough surface and 1 represents a smooth surface. "
     "This is the inverse of a roughness map in a PBR metal workflow."},
    {"material.pbr.specular.glossiness_map", "string", "", '0', 6, 0, kRead, "Filename of the glossiness map."},
    {"material.pbr.specular.light_map", "string", "", '0', 7, 0, kRead,
     "Filename of the light map. The light map is a prebaked light texture that is applied over the albedo map"},
    {"material.pbr.specular.light_map@uv_set", "unsigned int", "0", '0', 7, 0, kRead,
     "Index of the texture coordinate set to use."},
    {"material.pbr.specular.normal_map", "string", "", '0', 6, 0, kRead,
     "Filename of the normal map. The normals can be in the object space or tangent space as specified in the 'type' "
     "attribute"},
    {"material.pbr.specular.normal_map@type", "string", "tangent", '0', 6, 0, kRead,
     "The space that the normals are in. Values are: 'object' or 'tangent'"},
    {"material.pbr.specular.specular_map", "string", "", '0', 6, 0, kRead, "Filename of the specular map."},
    {"material.render_order", "float", "0.0", '0', 7, 0, kRead,
     "Set render order for coplanar polygons. The higher value will be rendered on top of the other coplanar polygons"},
    {"material.script", "", "", '0', 2, 0, kRead,
     "Name of material from an installed script file. This will override the color element if the script exists."},
    {"material.script.name", "string", "", '1', 2, 0, kRead, "Name of the script within the script file"},
    {"material.script.uri", "string", "", '+', 2, 0, kRead, "URI of the material script file"},
    {"material.shader", "", "", '0', 0, 0, kRead, ""},
    {"material.shader@type", "string", "pixel", '1', 0, 0, kRead,
     "vertex, pixel, normal_map_object_space, normal_map_tangent_space"},
    {"material.shader.normal_map", "string", "", '0', 0, 0, kRead, "filename of the normal map"},
    {"material.specular", "color", "0 0 0 1", '0', 0, 0, kRead,
     "The specular color of a material specified by set of four numbers representing red/green/blue/alpha, each in the "
     "range of [0,1]."},
    {"mesh", "", "", '1', 4, 0, kRead, "Mesh shape"},
    {"mesh.convex_decomposition", "", "", '0', 11, 0, kRead,
     "Convex decomposition parameters. Applicable if the mesh optimization attribute is set to convex_decomposition"},
    {"mesh.convex_decomposition.max_convex_hulls", "unsigned int", "16", '0', 11, 0, kRead,
     "Maximum number of convex hulls to decompose into. This sets the maximum number of submeshes that the final "
     "decomposed mesh will contain."},
    {"mesh.convex_decomposition.voxel_resolution", "unsigned int", "200000", '0', 11, 0, kRead,
     "The number of voxels to use for representing the source mesh before decomposition. Applicable only to voxel "
     "based "
     "convex decomposition methods."},
    {"mesh.scale", "vector3", "1 1 1", '0', 2, 0, kRead, "Scaling factor applied to the mesh"},
    {"mesh.submesh", "", "", '0', 3, 0, kRead,
     "Use a named submesh. The submesh must exist in the mesh specified by the uri"},
    {"mesh.submesh.center", "bool", "false", '0', 3, 0, kRead,
     "Set to true to center the vertices of the submesh at 0,0,0. This will effectively remove any transformations on "
     "the submesh before the poses from parent links and models are applied."},
    {"mesh.submesh.name", "string", "", '1', 3, 0, kRead, "Name of the submesh within the parent mesh"},
    {"mesh.uri", "string", "", '1', 2, 0, kRead, "Mesh uri"},
    {"mesh@optimization", "string", "", '0', 11, 0, kRead,
     "Set whether to optimize the mesh using one of the specified methods. Values include: \"convex_hull\" - a single "
     "convex hull that encapsulates the mesh, \"convex_decomposition\" - decompose the mesh into multiple convex hull "
     "meshes. Default value is an empty string which means no mesh optimization."},
    {"plane", "", "", '1', 4, 0, kRead, "Plane shape"},
    {"plane.normal", "vector3", "0 0 1", '1', 2, 0, kRead,
     "Normal direction for the plane. When a Plane is used as a geometry for a Visual or Collision object, then the "
     "normal is specified in the Visual or Collision frame, respectively."},
    {"plane.size", "vector2d", "1 1", '1', 2, 0, kRead,
     "Length of each side of the plane. Note that this property is meaningful only for visualizing the Plane, i.e., "
     "when the Plane is used as a geometry for a Visual object. The Plane has infinite size when used as a geometry "
     "for a Collision object."},
    {"polyline", "", "", '1', 5, 0, kRead, "Defines an extruded polyline shape"},
    {"polyline.height", "double", "1.0", '1', 5, 0, kRead, "Height of the polyline"},
    {"polyline.point", "vector2d", "0 0", '+', 5, 0, kRead, "A series of points that define the path of the polyline."},
    {"sphere", "", "", '1', 4, 0, kRead, "Sphere shape"},
    {"sphere.radius", "double", "1", '1', 2, 0, kRead, "radius of the sphere"},
    {"surface", "", "", '1', 0, 0, kRead, "The surface parameters"},
    {"surface.bounce", "", "", '0', 0, 0, kRead, ""},
    {"surface.bounce.restitution_coefficient", "double", "0", '0', 2, 0, kRead,
     "Bounciness coefficient of restitution, from [0...1], where 0=no bounciness."},
    {"surface.bounce.threshold", "double", "100000", '0', 2, 0, kRead,
     "Bounce capture velocity, below which effective coefficient of restitution is 0."},
    {"surface.contact", "", "", '0', 0, 0, kRead, ""},
    {"surface.contact.bullet", "", "", '0', 4, 0, kPassed, "Bullet contact parameters"},
    {"surface.contact.bullet.kd", "double", "1.0", '0', 4, 0, kPassed,
     "dynamically \"damping\"-equivalent coefficient for contact joints"},
    {"surface.contact.bullet.kp", "double", "1000000000000.0", '0', 4, 0, kPassed,
     "dynamically \"stiffness\"-equivalent coefficient for contact joints"},
    {"surface.contact.bullet.soft_cfm", "double", "0", '0', 4, 0, kPassed, "Soft constraint force mixing."},
    {"surface.contact.bullet.soft_erp", "double", "0.2", '0', 4, 0, kPassed, "Soft error reduction parameter"},
    {"surface.contact.bullet.split_impulse", "bool", "true", '1', 4, 0, kPassed,
     "Similar to ODE's max_vel implementation. See "
     "http://bulletphysics.org/mediawiki-1.5.8/index.php/BtContactSolverInfo#Split_Impulse for more information."},
    {"surface.contact.bullet.split_impulse_penetration_threshold", "double", "-0.01", '1', 4, 0, kPassed,
     "Similar to ODE's max_vel implementation. See "
     "http://bulletphysics.org/mediawiki-1.5.8/index.php/BtContactSolverInfo#Split_Impulse for more information."},
    {"surface.contact.category_bitmask", "unsigned int", "65535", '0', 6, 0, kPassed,
     "Bitmask for category of collision filtering. Collision happens if ((category1 & collision2) | (category2 & "
     "collision1)) is not zero. If not specified, the category_bitmask should be interpreted as being the same as "
     "collide_bitmask. Parsed as 16-bit unsigned integer."},
    {"surface.contact.collide_bitmask", "unsigned int", "65535", '0', 4, 0, kRead,
     "Bitmask for collision filtering. This will override collide_without_contact. Parsed as 16-bit unsigned integer."},
    {"surface.contact.collide_without_contact", "bool", "false", '0', 4, 0, kPassed,
     "Flag to disable contact force generation, while still allowing collision checks and contact visualization to "
     "occur."},
    {"surface.contact.collide_without_contact_bitmask", "unsigned int", "1", '0', 4, 0, kPassed,
     "Bitmask for collision filtering when collide_without_contact is on"},
    {"surface.contact.elastic_modulus", "double", "-1", '0', 5, 0, kPassed,
     "Young's Modulus in SI derived unit Pascal. Defaults to -1. If value is less or equal to zero, contact using "
     "elastic modulus (with Poisson's Ratio) is disabled. For reference, approximate values for Material:(Young's "
     "Modulus, Poisson's Ratio) for some of the typical materials are: Plastic: (1e8 ~ 3e9 Pa, 0.35 ~ 0.41), Wood: "
     "(4e9 ~ 1e10 Pa, 0.22 ~ 0.50), Aluminum: (7e10 Pa, 0.32 ~ 0.35), Steel: (2e11 Pa, 0.26 ~ 0.31)."},
    {"surface.contact.ode", "", "", '0', 0, 0, kRead, "ODE contact parameters"},
    {"surface.contact.ode.kd", "double", "1.0", '0', 2, 0, kRead,
     "dynamically \"damping\"-equivalent coefficient for contact joints"},
    {"surface.contact.ode.kp", "double", "1000000000000.0", '0', 2, 0, kRead,
     "dynamically \"stiffness\"-equivalent coefficient for contact joints"},
    {"surface.contact.ode.max_vel", "double", "0.01", '0', 2, 0, kPassed,
     "maximum contact correction velocity truncation term."},
    {"surface.contact.ode.min_depth", "double", "0", '0', 2, 0, kPassed,
     "minimum allowable depth before contact correction impulse is applied"},
    {"surface.contact.ode.soft_cfm", "double", "0", '0', 2, 0, kPassed, "Soft constraint force mixing."},
    {"surface.contact.ode.soft_erp", "double", "0.2", '0', 2, 0, kPassed, "Soft error reduction parameter"},
    {"surface.contact.poissons_ratio", "double", "0.3", '0', 5, 0, kPassed,
     "Poisson's ratio is the unitless ratio between transverse and axial strain. This value must lie between (-1, "
     "0.5). Defaults to 0.3 for typical steel. Note typical silicone elastomers have Poisson's ratio near 0.49 ~ 0.50. "
     "For reference, approximate values for Material:(Young's Modulus, Poisson's Ratio) for some of the typical "
     "materials are: Plastic: (1e8 ~ 3e9 Pa, 0.35 ~ 0.41), Wood: (4e9 ~ 1e10 Pa, 0.22 ~ 0.50), Aluminum: (7e10 Pa, "
     "0.32 ~ 0.35), Steel: (2e11 Pa, 0.26 ~ 0.31)."},
    {"surface.friction", "", "", '0', 0, 0, kRead, ""},
    {"surface.friction.bullet", "", "", '0', 4, 0, kPassed, ""},
    {"surface.friction.bullet.fdir1", "vector3", "0 0 0", '0', 4, 0, kPassed,
     "Unit vector specifying first friction pyramid direction in collision-fixed reference frame. If the friction "
     "pyramid model is in use, and this value is set to a unit vector for one of the colliding surfaces, the friction "
     "pyramid directions will be aligned with a reference frame fixed to that collision surface. If both surfaces have "
     "this value set to a vector of zeros, the friction pyramid directions will be aligned with the world frame. If "
     "this value is set for both surfaces, the behavior is undefined."},
    {"surface.friction.bullet.friction", "double", "1", '0', 4, 0, kPassed,
     "Coefficient of friction in first friction pyramid direction, the unitless maximum ratio of force in first "
     "friction pyramid direction to normal force."},
    {"surface.friction.bullet.friction2", "double", "1", '0', 4, 0, kPassed,
     "Coefficient of friction in second friction pyramid direction, the unitless maximum ratio of force in second "
     "friction pyramid direction to normal force."},
    {"surface.friction.bullet.rolling_friction", "double", "1", '0', 4, 0, kPassed, "Coefficient of rolling friction"},
    {"surface.friction.ode", "", "", '0', 0, 0, kRead, "ODE friction parameters"},
    {"surface.friction.ode.fdir1", "vector3", "0 0 0", '0', 2, 0, kRead,
     "Unit vector specifying first friction pyramid direction in collision-fixed reference frame. If the friction "
     "pyramid model is in use, and this value is set to a unit vector for one of the colliding surfaces, the ODE "
     "Collide callback function will align the friction pyramid directions with a reference frame fixed to that "
     "collision surface. If both surfaces have this value set to a vector of zeros, the friction pyramid directions "
     "will be aligned with the world frame. If this value is set for both surfaces, the behavior is undefined."},
    {"surface.friction.ode.mu", "double", "1", '0', 2, 0, kRead,
     "Coefficient of friction in first friction pyramid direction, the unitless maximum ratio of force in first "
     "friction pyramid direction to normal force."},
    {"surface.friction.ode.mu2", "double", "1", '0', 2, 0, kRead,
     "Coefficient of friction in second friction pyramid direction, the unitless maximum ratio of force in second "
     "friction pyramid direction to normal force."},
    {"surface.friction.ode.slip1", "double", "0.0", '0', 2, 0, kRead,
     "Force dependent slip in first friction pyramid direction, equivalent to inverse of viscous damping coefficient "
     "with units of m/s/N. A slip value of 0 is infinitely viscous."},
    {"surface.friction.ode.slip2", "double", "0.0", '0', 2, 0, kRead,
     "Force dependent slip in second friction pyramid direction, equivalent to inverse of viscous damping coefficient "
     "with units of m/s/N. A slip value of 0 is infinitely viscous."},
    {"surface.friction.torsional", "", "", '0', 5, 0, kRead, "Parameters for torsional friction"},
    {"surface.friction.torsional.coefficient", "double", "1.0", '0', 5, 0, kRead,
     "Torsional friction coefficient, unitless maximum ratio of tangential stress to normal stress."},
    {"surface.friction.torsional.ode", "", "", '0', 5, 0, kRead, "Torsional friction parameters for ODE"},
    {"surface.friction.torsional.ode.slip", "double", "0.0", '0', 5, 0, kRead,
     "Force dependent slip for torsional friction, equivalent to inverse of viscous damping coefficient with units of "
     "rad/s/(Nm). A slip value of 0 is infinitely viscous."},
    {"surface.friction.torsional.patch_radius", "double", "0", '0', 5, 0, kRead, "Radius of contact patch surface."},
    {"surface.friction.torsional.surface_radius", "double", "0.0", '0', 5, 0, kRead,
     "Surface radius on the point of contact."},
    {"surface.friction.torsional.use_patch_radius", "bool", "true", '0', 5, 0, kRead,
     "If this flag is true, torsional friction is calculated using the \"patch_radius\" parameter. If this flag is set "
     "to false, \"surface_radius\" (R) and contact depth (d) are used to compute the patch radius as sqrt(R*d)."},
    {"surface.soft_contact", "", "", '0', 4, 0, kPassed, ""},
    {"surface.soft_contact.dart", "", "", '0', 4, 0, kPassed,
     "soft contact pamameters based on paper: "
     "http://www.cc.gatech.edu/graphics/projects/Sumit/homepage/papers/sigasia11/jain_softcontacts_siga11.pdf"},
    {"surface.soft_contact.dart.bone_attachment", "double", "100.0", '1', 4, 0, kPassed,
     "This is variable k_v in the soft contacts paper. Its unit is N/m."},
    {"surface.soft_contact.dart.damping", "double", "10.0", '1', 4, 0, kPassed,
     "Viscous damping of point velocity in body frame. Its unit is N/m/s."},
    {"surface.soft_contact.dart.flesh_mass_fraction", "double", "0.05", '1', 4, 0, kPassed,
     "Fraction of mass to be distributed among deformable nodes."},
    {"surface.soft_contact.dart.stiffness", "double", "100.0", '1', 4, 0, kPassed,
     "This is variable k_e in the soft contacts paper. Its unit is N/m."},
    {"visual", "", "", '1', 0, 0, kRead,
     "The visual properties of the link. This element specifies the shape of the object (box, cylinder, etc.) for "
     "visualization purposes."},
    {"visual@name", "string", "", '1', 0, 0, kRead,
     "Unique name for the visual element within the scope of the parent link."},
    {"visual.cast_shadows", "bool", "true", '0', 2, 0, kRead, "If true the visual will cast shadows."},
    {"visual.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"visual.geometry", "+geometry", "", '1', 0, 0, kRead, ""},
    {"visual.laser_retro", "double", "0.0", '0', 2, 0, kRead, "will be implemented in the future release."},
    {"visual.material", "+material", "", '0', 0, 0, kRead, ""},
    {"visual.meta", "", "", '0', 5, 0, kRead,
     "Optional meta information for the visual. The information contained within this element should be used to "
     "provide additional feedback to an end user."},
    {"visual.meta.layer", "int", "0", '0', 5, 0, kRead,
     "The layer in which this visual is displayed. The layer number is useful for programs, such as Gazebo, that put "
     "visuals in different layers for enhanced visualization."},
    {"visual.plugin", "+plugin", "", '*', 3, 0, kRead, ""},
    {"visual.pose", "+pose", "", '0', 2, 0, kRead, ""},
    {"visual.transparency", "double", "0.0", '0', 2, 0, kRead,
     "The amount of transparency( 0=opaque, 1 = fully transparent)"},
    {"visual.visibility_flags", "unsigned int", "4294967295", '0', 7, 0, kRead,
     "Visibility flags of a visual. When (camera's visibility_mask & visual's visibility_flags) evaluates to non-zero, "
     "the visual will be visible to the camera."},
};

}  // namespace

std::span<const SchemaRow> shapeRows() { return kShapeRows; }

}  // namespace pongsim::sdf
