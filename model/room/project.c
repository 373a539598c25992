/* project.c - see project.h. */
#include "model/room/project.h"

#include <stddef.h>

const struct pp_project_fact pp_project_facts[PP_PROJECT_FACTS] = {
    {"name", "project"},       {"client", "client"},      {"number", "project number"},
    {"author", "prepared by"}, {"checked", "checked by"}, {"date", "date"},
    {"revision", "revision"},
};

const char **pp_project_place(struct pp_project *project, int index)
{
    const char **const places[PP_PROJECT_FACTS] = {
        &project->name,    &project->client, &project->number,  &project->author,
        &project->checked, &project->date,   &project->revision};
    return places[index];
}

const char *pp_project_at(const struct pp_project *project, int index)
{
    struct pp_project copy = *project;
    return *pp_project_place(&copy, index);
}
