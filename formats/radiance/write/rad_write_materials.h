/* rad_write_materials.h - materials and patterns as primitives of a Radiance scene. */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_WRITE_MATERIALS_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_WRITE_MATERIALS_H

#include <stdbool.h>
#include <stdio.h>

#include "model/base/error.h"
#include "model/light/material.h"

struct pp_rad_writer;
struct pp_rad_pair;

/* Writes all patterns and materials of the writer's scene; errors of the stream are the
 * caller's to look for. */
void pp_rad_write_materials(const struct pp_rad_writer *writer, FILE *out);

/* PP_BAD_INPUT where Radiance has no type for the material. */
enum pp_status pp_rad_write_materials_check(const struct pp_material *material,
                                            struct pp_error *err);

/* Fills the writer's in_pairs, on_its_own and behind by its pairs and shapes. */
void pp_rad_write_materials_classify(struct pp_rad_writer *writer);

/* Is the pair a mirror as Radiance has it, black from behind and used in no other
 * way? */
bool pp_rad_write_materials_is_mirror(const struct pp_rad_writer *writer,
                                      const struct pp_rad_pair *pair);

#endif
