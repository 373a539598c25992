/* engine_radiosity.c - adapts the finite elements (simulate/research/radiosity) as an
 * engine. */
#include "simulate/research/radiosity/radiosity.h"
#include "studies/engines/engine.h"
#include "studies/engines/scattering_panes.h"

static enum pp_status create_radiosity_engine(void **data,
                                              const struct pp_light_scene *scene,
                                              const struct pp_environment *environment,
                                              const struct pp_report *report,
                                              const struct pp_engine_options *options,
                                              struct pp_error *err)
{
    enum pp_status able = pp_scattering_panes_refuse(report->world, "radiosity", err);
    if (able != PP_OK)
        return able;
    if (report->world->tree_count > 0)
        return pp_fail(
            err, PP_BAD_INPUT,
            "engine radiosity: the site has trees, through which this engine "
            "cannot follow light; expected the engine path, cache or photons");
    if (report->world->outer_pane_count > 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "engine radiosity: the coarse model of within has panes between "
                       "the room and the sky, which this engine cannot follow; "
                       "expected the engine path, cache or photons");
    const struct pp_radiosity_options wanted = {.error = options->error,
                                                .threads = options->threads};
    struct pp_radiosity *radiosity;
    (void)scene, (void)environment; /* radiosity makes its own scene */
    enum pp_status status =
        pp_radiosity_create(&radiosity, report->world, &report->light,
                            report->receivers, report->receiver_count, &wanted, err);
    *data = radiosity;
    return status;
}

static enum pp_status advance_radiosity_engine(void *data, double seconds,
                                               struct pp_error *err)
{
    (void)seconds; /* a level cannot be interrupted by the time limit */
    return pp_radiosity_advance(data, err);
}

static bool radiosity_engine_done(const void *data)
{
    return pp_radiosity_done(data);
}

static double radiosity_engine_progress(const void *data)
{
    return pp_radiosity_progress(data);
}

static double radiosity_engine_error(const void *data)
{
    return pp_radiosity_error(data);
}

static void read_radiosity_engine(const void *data, int index,
                                  struct pp_reading readings[PP_COMPONENT_COUNT])
{
    pp_radiosity_read(data, index, readings);
}

static void destroy_radiosity_engine(void *data)
{
    pp_radiosity_destroy(data);
}

const struct pp_engine pp_engine_radiosity = {
    .name = "radiosity",
    .column = "radiosity",
    .summary = "finite elements, without random numbers",
    .said = "by finite elements",
    .deviation = "the error bound of the mesh refinement, valid for 19 in 20 values",
    .from = "from radiosity, %",
    .is_truth = true,
    .is_sampled = false,
    .create = create_radiosity_engine,
    .advance = advance_radiosity_engine,
    .done = radiosity_engine_done,
    .progress = radiosity_engine_progress,
    .error = radiosity_engine_error,
    .read = read_radiosity_engine,
    .destroy = destroy_radiosity_engine,
};
