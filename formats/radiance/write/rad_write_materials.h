/* rad_write_materials.h - materials and patterns as primitives of a Radiance scene. */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_WRITE_MATERIALS_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_WRITE_MATERIALS_H

#include <stdbool.h>
#include <stdio.h>

#include "model/base/error.h"
#include "model/light/material.h"
#include "model/light/scene_description.h"

struct pp_rad_writer;
struct pp_rad_pair;

/* Writes all patterns and materials of the writer's scene. The caller checks the stream
 * for errors. */
void pp_rad_write_materials(const struct pp_rad_writer *writer, FILE *out);

/* Number of the data file of a scattering pane, from 1, given the material of the
 * pane's room side; 0 for other materials. Panes with equal data and losses share a
 * file. */
#define PP_RAD_PANE_FILE "pane_%d.xml"
int pp_rad_write_materials_pane(const struct pp_scene_description *scene, int material);

/* PP_BAD_INPUT if no Radiance type can describe the material. */
enum pp_status pp_rad_write_materials_check(const struct pp_material *material,
                                            struct pp_error *err);

/* Sets the writer's in_pairs, on_its_own and behind from its pairs and shapes. */
void pp_rad_write_materials_classify(struct pp_rad_writer *writer);

/* True if the pair can be a Radiance mirror: its front has only a mirror reflection and
 * is never used as a back, and its back is black. */
bool pp_rad_write_materials_is_mirror(const struct pp_rad_writer *writer,
                                      const struct pp_rad_pair *pair);

#endif
