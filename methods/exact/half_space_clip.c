/* half_space_clip.c - clips by a pipeline of stages, one for each half-space [SH74].
 * Each stage passes on the vertices on its side, and no polygon is stored. */
#include "methods/exact/half_space_clip.h"

#include <assert.h>
#include <stdbool.h>

struct clip_stage {
    struct pp_vec3 half_space;
    bool begun;
    struct pp_vec3 first, last;
    double first_depth, last_depth;
};

struct clip {
    struct clip_stage stages[PP_HALF_SPACES_MOST];
    int count;
    pp_half_space_sink *sink;
    void *data;
};

static void clip_vertex(struct clip *clip, int index, struct pp_vec3 v);

static double size_of(struct pp_vec3 v)
{
    return fabs(v.x) + fabs(v.y) + fabs(v.z);
}

/* The depth of v within a half-space, set to 0 if it is below rounding error, so that a
 * patch that only touches the plane leaves no sliver. */
static double depth_in(struct pp_vec3 half_space, struct pp_vec3 v)
{
    double depth = pp_vec_dot(half_space, v);
    return fabs(depth) > 1e-15 * size_of(half_space) * size_of(v) ? depth : 0.0;
}

/* The point where the edge between an inner and an outer point meets the stage's plane.
 * The calculation always starts from the inner point, so that two polygons agree on a
 * shared edge. */
static struct pp_vec3 stage_crossing(struct pp_vec3 inner, double inner_depth,
                                     struct pp_vec3 outer, double outer_depth)
{
    return pp_vec_along(inner, inner_depth / (inner_depth - outer_depth),
                        pp_vec_sub(outer, inner));
}

static void clip_edge(struct clip *clip, int index, struct pp_vec3 a, double depth_a,
                      struct pp_vec3 b, double depth_b)
{
    if ((depth_a > 0.0) == (depth_b > 0.0))
        return;
    clip_vertex(clip, index + 1,
                depth_a > 0.0 ? stage_crossing(a, depth_a, b, depth_b)
                              : stage_crossing(b, depth_b, a, depth_a));
}

static void clip_vertex(struct clip *clip, int index, struct pp_vec3 v)
{
    if (index == clip->count) {
        clip->sink(clip->data, v);
        return;
    }
    struct clip_stage *stage = &clip->stages[index];
    double depth = depth_in(stage->half_space, v);
    if (stage->begun) {
        clip_edge(clip, index, stage->last, stage->last_depth, v, depth);
    } else {
        stage->first = v;
        stage->first_depth = depth;
        stage->begun = true;
    }
    if (depth > 0.0)
        clip_vertex(clip, index + 1, v);
    stage->last = v;
    stage->last_depth = depth;
}

void pp_half_space_clip(const struct pp_vec3 *vertices, int count,
                        const struct pp_vec3 *half_spaces, int half_space_count,
                        pp_half_space_sink *sink, void *data)
{
    assert(half_space_count <= PP_HALF_SPACES_MOST);
    struct clip clip;
    clip.count = 0;
    clip.sink = sink;
    clip.data = data;

    /* A half-space that contains the whole ring needs no stage. */
    for (int h = 0; h < half_space_count; h++) {
        int inside = 0;
        for (int i = 0; i < count; i++)
            inside += depth_in(half_spaces[h], vertices[i]) > 0.0;
        if (inside == 0)
            return;
        if (inside < count) {
            clip.stages[clip.count].half_space = half_spaces[h];
            clip.stages[clip.count++].begun = false;
        }
    }
    for (int i = 0; i < count; i++)
        clip_vertex(&clip, 0, vertices[i]);
    for (int s = 0; s < clip.count; s++) {
        struct clip_stage *stage = &clip.stages[s];
        if (stage->begun)
            clip_edge(&clip, s, stage->last, stage->last_depth, stage->first,
                      stage->first_depth);
    }
}
