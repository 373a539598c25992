/* project.h - for whom and by whom a room file was made, for the title block of
 * reports. */
#ifndef PP_MODEL_ROOM_PROJECT_H
#define PP_MODEL_ROOM_PROJECT_H

/* Each NULL where it is not given. */
struct pp_project {
    const char *name, *client, *number, *author, *checked, *date, *revision;
};

enum { PP_PROJECT_FACTS = 7 };

/* Attribute of the element <project>, option of report, and label of a fact. */
struct pp_project_fact {
    const char *name, *label;
};
extern const struct pp_project_fact pp_project_facts[PP_PROJECT_FACTS];

/* The fact of that index, in the order of pp_project_facts; NULL: not given. */
const char *pp_project_at(const struct pp_project *project, int index);

/* The place of that fact. */
const char **pp_project_place(struct pp_project *project, int index);

#endif
