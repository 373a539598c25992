/* rays.c - triangles and round shapes in a scene of Embree, and rays sent through
 * it. */
#include "config.h"

#include "simulate/scene/rays.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#ifdef HAVE_EMBREE4
/* Embree's headers declare functions without a prototype. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wstrict-prototypes"
#include <embree4/rtcore.h>
#pragma GCC diagnostic pop
#else
#include <embree3/rtcore.h>
#endif

#include "model/base/late_library.h"
#include "simulate/scene/round.h"

/* Embree is loaded with the first scene, since many a command needs none; its functions are
 * looked up for each. */
#ifdef HAVE_EMBREE4
#define EMBREE_FILE "libembree4.so.4"
#else
#define EMBREE_FILE "libembree3.so.3"
#endif

/* What is called of it. */
/* clang-format off */
#define EMBREE_FUNCTIONS(each) \
    each(rtcAttachGeometry) each(rtcCommitGeometry) each(rtcCommitScene) \
    each(rtcGetDeviceError) each(rtcIntersect1) each(rtcNewDevice) \
    each(rtcNewGeometry) each(rtcNewScene) each(rtcReleaseDevice) \
    each(rtcReleaseGeometry) each(rtcReleaseScene) \
    each(rtcSetGeometryBoundsFunction) each(rtcSetGeometryIntersectFunction) \
    each(rtcSetGeometryUserData) each(rtcSetGeometryUserPrimitiveCount) \
    each(rtcSetNewGeometryBuffer) each(rtcSetSceneFlags)
/* clang-format on */

#define MEMBER(name) __typeof__(name) *name;
#define NAME(name) #name,
struct embree {
    EMBREE_FUNCTIONS(MEMBER)
};
static const char *const embree_names[] = {EMBREE_FUNCTIONS(NAME) NULL};

struct pp_rays {
    struct embree embree;
    RTCDevice device;
    RTCScene scene;
    struct pp_shape *rounds;
    unsigned round_geometry; /* as hits name it */
    int triangle_count;
};

/* Embree's last error, as ours. */
static enum pp_status embree_failed(const struct pp_rays *rays, struct pp_error *err)
{
    enum RTCError code = rays->embree.rtcGetDeviceError(rays->device);
    if (code == RTC_ERROR_OUT_OF_MEMORY)
        return pp_fail_memory(err);
    return pp_fail(err, PP_SYSTEM,
                   "the ray kernels (Embree) failed with error %d; is this processor "
                   "too old for them?",
                   (int)code);
}

static enum pp_status attach_triangles(struct pp_rays *rays,
                                       const float (*triangles)[3][3], int count,
                                       struct pp_error *err)
{
    const struct embree *embree = &rays->embree;
    RTCGeometry mesh = embree->rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    if (!mesh)
        return embree_failed(rays, err);
    float *vertices = embree->rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
        (size_t)count * 3);
    unsigned *indices = embree->rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
        (size_t)count);
    if (vertices && indices) {
        memcpy(vertices, triangles, (size_t)count * sizeof *triangles);
        for (unsigned i = 0; i < 3u * (unsigned)count; i++)
            indices[i] = i;
        embree->rtcCommitGeometry(mesh);
        embree->rtcAttachGeometry(rays->scene, mesh);
    }
    embree->rtcReleaseGeometry(mesh);
    if (!vertices || !indices)
        return embree_failed(rays, err);
    return PP_OK;
}

/* Rounded away from the inside of a box. */
static float rounded_down(double x)
{
    return nextafterf((float)x, -INFINITY);
}

static float rounded_up(double x)
{
    return nextafterf((float)x, INFINITY);
}

static void round_bounds(const struct RTCBoundsFunctionArguments *asked)
{
    const struct pp_shape *rounds = asked->geometryUserPtr;
    struct pp_bounds3 box = pp_round_bounds(&rounds[asked->primID]);
    *asked->bounds_o = (struct RTCBounds){.lower_x = rounded_down(box.low.x),
                                          .lower_y = rounded_down(box.low.y),
                                          .lower_z = rounded_down(box.low.z),
                                          .upper_x = rounded_up(box.high.x),
                                          .upper_y = rounded_up(box.high.y),
                                          .upper_z = rounded_up(box.high.z)};
}

static void round_intersect(const struct RTCIntersectFunctionNArguments *asked)
{
    const struct pp_shape *rounds = asked->geometryUserPtr;
    struct RTCRayHit *query = (struct RTCRayHit *)asked->rayhit;
    double t;
    if (!asked->valid[0]
        || !pp_round_meet(&rounds[asked->primID],
                          pp_vec(query->ray.org_x, query->ray.org_y, query->ray.org_z),
                          pp_vec(query->ray.dir_x, query->ray.dir_y, query->ray.dir_z),
                          query->ray.tnear, query->ray.tfar, &t))
        return;
    query->ray.tfar = (float)t;
    query->hit.geomID = asked->geomID;
    query->hit.primID = asked->primID;
}

static enum pp_status attach_rounds(struct pp_rays *rays, const struct pp_shape *rounds,
                                    int count, struct pp_error *err)
{
    rays->rounds = malloc((size_t)count * sizeof *rounds);
    if (!rays->rounds)
        return pp_fail_memory(err);
    memcpy(rays->rounds, rounds, (size_t)count * sizeof *rounds);
    const struct embree *embree = &rays->embree;
    RTCGeometry geometry = embree->rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_USER);
    if (!geometry)
        return embree_failed(rays, err);
    embree->rtcSetGeometryUserPrimitiveCount(geometry, (unsigned)count);
    embree->rtcSetGeometryUserData(geometry, rays->rounds);
    embree->rtcSetGeometryBoundsFunction(geometry, round_bounds, NULL);
    embree->rtcSetGeometryIntersectFunction(geometry, round_intersect);
    embree->rtcCommitGeometry(geometry);
    rays->round_geometry = embree->rtcAttachGeometry(rays->scene, geometry);
    embree->rtcReleaseGeometry(geometry);
    return PP_OK;
}

enum pp_status pp_rays_create(struct pp_rays **result, const float (*triangles)[3][3],
                              int count, const struct pp_shape *rounds, int round_count,
                              struct pp_error *err)
{
    *result = NULL;
    struct pp_rays *rays = calloc(1, sizeof *rays);
    if (!rays)
        return pp_fail_memory(err);
    rays->triangle_count = count;
    rays->round_geometry = RTC_INVALID_GEOMETRY_ID;
    const struct embree *embree = &rays->embree;
    enum pp_status status =
        pp_late_library_load(&rays->embree, embree_names, EMBREE_FILE, err);
    if (status != PP_OK)
        goto failed;
    rays->device = embree->rtcNewDevice("threads=1,set_affinity=0");
    if (!rays->device) {
        status = embree_failed(rays, err);
        goto failed;
    }
    rays->scene = embree->rtcNewScene(rays->device);
    if (!rays->scene) {
        status = embree_failed(rays, err);
        goto failed;
    }
    embree->rtcSetSceneFlags(rays->scene, RTC_SCENE_FLAG_ROBUST);
    if (count > 0)
        status = attach_triangles(rays, triangles, count, err);
    if (status == PP_OK && round_count > 0)
        status = attach_rounds(rays, rounds, round_count, err);
    if (status != PP_OK)
        goto failed;
    embree->rtcCommitScene(rays->scene);
    if (embree->rtcGetDeviceError(rays->device) != RTC_ERROR_NONE) {
        status = pp_fail_memory(err);
        goto failed;
    }
    *result = rays;
    return PP_OK;
failed:
    pp_rays_destroy(rays);
    return status;
}

void pp_rays_destroy(struct pp_rays *rays)
{
    if (!rays)
        return;
    if (rays->scene)
        rays->embree.rtcReleaseScene(rays->scene);
    if (rays->device)
        rays->embree.rtcReleaseDevice(rays->device);
    free(rays->rounds);
    free(rays);
}

int pp_rays_first(const struct pp_rays *rays, const float origin[3],
                  const float direction[3], float *distance)
{
    struct RTCRayHit query = {
        .ray = {.org_x = origin[0],
                .org_y = origin[1],
                .org_z = origin[2],
                .dir_x = direction[0],
                .dir_y = direction[1],
                .dir_z = direction[2],
                .tfar = INFINITY,
                .mask = ~0u},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .primID = RTC_INVALID_GEOMETRY_ID}};
#ifdef HAVE_EMBREE4
    rays->embree.rtcIntersect1(rays->scene, &query, NULL);
#else
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rays->embree.rtcIntersect1(rays->scene, &context, &query);
#endif
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return -1;
    *distance = query.ray.tfar;
    return (int)query.hit.primID
           + (query.hit.geomID == rays->round_geometry ? rays->triangle_count : 0);
}
