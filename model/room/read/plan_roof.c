/* plan_roof.c - see plan_roof.h.
 *
 * Faces are made with the ridge along u, from 0 to l, and v across it, from 0 to w. If
 * the ridge runs along the depth they are rotated: x = v, y = depth - u. Corners are
 * counter-clockwise seen from inside.
 */
#include "model/room/read/plan_roof.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct roof_frame {
    struct pp_reader *r;
    struct pp_plan_part *plan;
    double l, w, eaves, rise; /* rise of the roof, or of a tooth, above the eaves */
    double depth_m;
    bool turned;
    int line;
};

/* Names of walls and slopes at v = 0, u = l, v = w and u = 0, by `turned`. */
static const char *const sides[2][4] = {{"south", "east", "north", "west"},
                                        {"west", "south", "east", "north"}};

static void add_roof_face(const struct roof_frame *f, enum pp_role role,
                          const char *name, const struct pp_vec3 *corners, int count)
{
    struct pp_face_part face = {.role = role, .reflectance = NAN, .line = f->line};
    for (int i = 0; i < count; i++) {
        if (!PP_READER_RESERVE(f->r, face.vertices.lines, i)
            || !PP_READER_RESERVE(f->r, face.vertices.list, i))
            break;
        struct pp_vec3 p = corners[i];
        face.vertices.lines[i] = f->line;
        face.vertices.list[i] = f->turned ? pp_vec(p.y, f->depth_m - p.x, p.z) : p;
        face.vertices.count++;
    }
    face.name = pp_reader_copy_text(f->r, name);
    if (face.vertices.count == count
        && PP_READER_RESERVE(f->r, f->plan->faces, f->plan->face_count)) {
        f->plan->faces[f->plan->face_count++] = face;
        return;
    }
    free(face.name);
    pp_room_parts_clear_vertices(&face.vertices);
}

static void add_slope(const struct roof_frame *f, int side,
                      const struct pp_vec3 *corners, int count)
{
    char name[16];
    snprintf(name, sizeof name, "roof-%s", sides[f->turned][side]);
    add_roof_face(f, PP_CEILING, name, corners, count);
}

static void add_floor(const struct roof_frame *f)
{
    add_roof_face(
        f, PP_FLOOR, "floor",
        (struct pp_vec3[]){{0, 0, 0}, {f->l, 0, 0}, {f->l, f->w, 0}, {0, f->w, 0}}, 4);
}

/* Adds the walls parallel to the ridge, with these heights. */
static void add_long_walls(const struct roof_frame *f, double near, double far)
{
    double l = f->l, w = f->w;
    add_roof_face(f, PP_WALL, sides[f->turned][0],
                  (struct pp_vec3[]){{l, 0, 0}, {0, 0, 0}, {0, 0, near}, {l, 0, near}},
                  4);
    add_roof_face(f, PP_WALL, sides[f->turned][2],
                  (struct pp_vec3[]){{0, w, 0}, {l, w, 0}, {l, w, far}, {0, w, far}},
                  4);
}

/* Adds the walls across the ridge; line: points (v, z) of their upper edge, from v = 0
 * to v = w. */
static void add_end_walls(const struct roof_frame *f, const double (*line)[2],
                          int count)
{
    struct pp_vec3 corners[2 * PP_PLAN_ROOF_TEETH_MOST + 2];
    for (int end = 0; end < 2; end++) {
        double u = end ? 0.0 : f->l;
        int n = 0;
        corners[n++] = pp_vec(u, end ? 0.0 : f->w, 0.0);
        corners[n++] = pp_vec(u, end ? f->w : 0.0, 0.0);
        for (int i = 0; i < count; i++) {
            const double *at = line[end ? count - 1 - i : i];
            corners[n++] = pp_vec(u, at[0], at[1]);
        }
        add_roof_face(f, PP_WALL, sides[f->turned][end ? 3 : 1], corners, n);
    }
}

static void raise_mono(const struct roof_frame *f)
{
    double l = f->l, w = f->w, low = f->eaves, top = low + f->rise;
    add_long_walls(f, low, top);
    add_end_walls(f, (const double[][2]){{0, low}, {w, top}}, 2);
    add_slope(f, 0,
              (struct pp_vec3[]){{l, 0, low}, {0, 0, low}, {0, w, top}, {l, w, top}},
              4);
}

static void raise_gable(const struct roof_frame *f)
{
    double l = f->l, w = f->w, low = f->eaves, top = low + f->rise, m = 0.5 * w;
    add_long_walls(f, low, low);
    add_end_walls(f, (const double[][2]){{0, low}, {m, top}, {w, low}}, 3);
    add_slope(f, 0,
              (struct pp_vec3[]){{l, 0, low}, {0, 0, low}, {0, m, top}, {l, m, top}},
              4);
    add_slope(f, 2,
              (struct pp_vec3[]){{0, w, low}, {l, w, low}, {l, m, top}, {0, m, top}},
              4);
}

static void raise_hip(const struct roof_frame *f)
{
    double l = f->l, w = f->w, low = f->eaves, top = low + f->rise, m = 0.5 * w;
    int long_corners = l - w < 1e-6 * l ? 3 : 4; /* slopes of a pyramid are triangles */
    add_long_walls(f, low, low);
    add_end_walls(f, (const double[][2]){{0, low}, {w, low}}, 2);
    add_slope(
        f, 0,
        (struct pp_vec3[]){{l, 0, low}, {0, 0, low}, {m, m, top}, {l - m, m, top}},
        long_corners);
    add_slope(f, 1, (struct pp_vec3[]){{l, w, low}, {l, 0, low}, {l - m, m, top}}, 3);
    add_slope(
        f, 2,
        (struct pp_vec3[]){{0, w, low}, {l, w, low}, {l - m, m, top}, {m, m, top}},
        long_corners);
    add_slope(f, 3, (struct pp_vec3[]){{0, 0, low}, {0, w, low}, {m, m, top}}, 3);
}

/* Each tooth rises from low v to high v and ends in a vertical face; the last one ends
 * in the far wall. */
static void raise_teeth(const struct roof_frame *f, int teeth)
{
    double l = f->l, low = f->eaves, top = low + f->rise, step = f->w / teeth;
    double line[2 * PP_PLAN_ROOF_TEETH_MOST][2];
    for (int i = 0; i < teeth; i++) {
        line[2 * i][0] = step * i;
        line[2 * i][1] = low;
        line[2 * i + 1][0] = i + 1 < teeth ? step * (i + 1) : f->w;
        line[2 * i + 1][1] = top;
    }
    add_long_walls(f, low, top);
    add_end_walls(f, (const double(*)[2])line, 2 * teeth);
    for (int i = 0; i < teeth; i++) {
        double from = line[2 * i][0], to = line[2 * i + 1][0];
        char name[24];
        snprintf(name, sizeof name, "roof-%d", i + 1);
        add_roof_face(f, PP_CEILING, name,
                      (struct pp_vec3[]){
                          {l, from, low}, {0, from, low}, {0, to, top}, {l, to, top}},
                      4);
        if (i + 1 == teeth)
            break;
        snprintf(name, sizeof name, "light-%d", i + 1);
        add_roof_face(
            f, PP_WALL, name,
            (struct pp_vec3[]){{0, to, low}, {l, to, low}, {l, to, top}, {0, to, top}},
            4);
    }
}

void pp_plan_roof_add(struct pp_reader *r, struct pp_plan_part *plan,
                      const struct pp_plan_roof *roof)
{
    bool longer = roof->ridge == PP_RIDGE_LONGER || roof->roof == PP_ROOF_HIP;
    struct roof_frame f = {.r = r,
                           .plan = plan,
                           .eaves = roof->height_m,
                           .depth_m = roof->depth_m,
                           .line = roof->line};
    f.turned = longer ? roof->depth_m > roof->width_m : roof->ridge == PP_RIDGE_DEPTH;
    f.l = f.turned ? roof->depth_m : roof->width_m;
    f.w = f.turned ? roof->width_m : roof->depth_m;
    double run = roof->roof == PP_ROOF_MONO        ? f.w
                 : roof->roof == PP_ROOF_SAW_TOOTH ? f.w / roof->teeth
                                                   : 0.5 * f.w;
    f.rise = run * tan(roof->pitch_rad);
    plan->envelope = true;
    plan->width_m = plan->depth_m = plan->height_m = NAN;
    add_floor(&f);
    if (roof->roof == PP_ROOF_MONO)
        raise_mono(&f);
    else if (roof->roof == PP_ROOF_GABLE)
        raise_gable(&f);
    else if (roof->roof == PP_ROOF_HIP)
        raise_hip(&f);
    else
        raise_teeth(&f, roof->teeth);
}
