/* endpoint.c - the list of endpoints. */
#include "serve/endpoint.h"

#include <string.h>

#include "serve/answers/answer_program.h"
#include "serve/answers/answer_study.h"
#include "serve/answers/answer_about.h"
#include "serve/stores/job_store.h"
#include "serve/answers/stream_annual.h"
#include "serve/answers/stream_render.h"
#include "serve/answers/stream_trace.h"
#include "serve/stores/weather_store.h"

enum { ROOM_BYTES = 1 << 20, WEATHER_BYTES = 8 << 20 };

#define JSON_POST(name, work_line, function, text)                                     \
    {                                                                                  \
        "POST", "/api/" name, "application/json", ROOM_BYTES, work_line, function,     \
            text                                                                       \
    }

static const struct pp_endpoint endpoints[] = {
    {"GET", "/api/about", NULL, 0, PP_LINE_STUDIES, pp_answer_about,
     "Version, methods, charts, criteria, example rooms"},
    {"GET", "/api/room", NULL, 0, PP_LINE_STUDIES, pp_answer_about_room,
     "The room file with which the server was started"},
    JSON_POST("df", PP_LINE_STUDIES, pp_answer_study_df,
              "Daylight factors by hand methods, as from pepperpot df"),
    JSON_POST("plan", PP_LINE_STUDIES, pp_answer_study_plan,
              "Contours and no-sky line as polylines, and the room's geometry"),
    JSON_POST("check", PP_LINE_STUDIES, pp_answer_study_check,
              "All errors in a room file, with lines and columns"),
    JSON_POST("trace", PP_LINE_STUDIES, pp_stream_trace,
              "Simulated daylight factors as a stream of events"),
    JSON_POST("chart/", PP_LINE_PROGRAMS, pp_answer_program,
              "A chart, as from pepperpot chart KIND"),
    JSON_POST("assess", PP_LINE_PROGRAMS, pp_answer_program,
              "Criteria, as from pepperpot assess"),
    JSON_POST("size", PP_LINE_PROGRAMS, pp_answer_program,
              "Window sizes for a target, as from pepperpot size"),
    JSON_POST("availability", PP_LINE_PROGRAMS, pp_answer_program,
              "Share of working hours with enough daylight, as from pepperpot "
              "availability"),
    JSON_POST("annual", PP_LINE_PROGRAMS, pp_stream_annual,
              "Daylight in every hour of a weather file as a stream of events, or as "
              "from pepperpot annual"),
    JSON_POST("report", PP_LINE_PROGRAMS, pp_answer_program,
              "The report, as from pepperpot report"),
    JSON_POST("import", PP_LINE_PROGRAMS, pp_answer_program_import,
              "A gbXML file converted to a room file, as by pepperpot import"),
    JSON_POST("render", PP_LINE_PROGRAMS, pp_stream_render,
              "A picture as a stream of events, coarse at first"),
    {"POST", "/api/weather", "application/octet-stream", WEATHER_BYTES, PP_LINE_STUDIES,
     pp_weather_store_put, "Stores a weather file under its hash"},
    JSON_POST("jobs", PP_LINE_STUDIES, pp_job_store_put,
              "Starts a command; its result is fetched later"),
    {"GET", "/api/jobs/", NULL, 0, PP_LINE_STUDIES, pp_job_store_get,
     "State of a job, or its result"},
};

const struct pp_endpoint *pp_endpoint_at(int index)
{
    return index < (int)(sizeof endpoints / sizeof *endpoints) ? &endpoints[index]
                                                               : NULL;
}

/* True if the path belongs to the endpoint. If the endpoint's path ends with "/",
 * `kind` is set to the rest of the path, which must be lower-case letters, digits and
 * hyphens. */
static bool matches(const struct pp_endpoint *endpoint, const char *path, char kind[32])
{
    static const char in_kind[] = "abcdefghijklmnopqrstuvwxyz0123456789-";
    size_t length = strlen(endpoint->path);
    kind[0] = '\0';
    if (endpoint->path[length - 1] != '/')
        return strcmp(endpoint->path, path) == 0;
    if (strncmp(endpoint->path, path, length) != 0)
        return false;
    path += length;
    size_t rest = strlen(path);
    if (rest == 0 || rest >= 32 || strspn(path, in_kind) != rest)
        return false;
    memcpy(kind, path, rest + 1);
    return true;
}

const struct pp_endpoint *pp_endpoint_find(const char *method, const char *path,
                                           char kind[32], const char **allowed)
{
    const struct pp_endpoint *endpoint;
    *allowed = NULL;
    for (int i = 0; (endpoint = pp_endpoint_at(i)); i++) {
        if (!matches(endpoint, path, kind))
            continue;
        if (strcmp(endpoint->method, method) == 0)
            return endpoint;
        *allowed = endpoint->method;
    }
    return NULL;
}
