#include "show/lab_page.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "show/stages.h"

LabPage* lab_page_open(bool timed) {
    LabPage* lab = new_array(LabPage, 1);
    lab->timed = timed;
    lab_page_begin(lab);
    return lab;
}

void lab_page_begin(LabPage* lab) {
    history_begin(&lab->history);
    lab->spent = 0;
    lab->steps = 0;
}

void lab_page_start(LabPage* lab) {
    lab->since = lab->timed ? stages_now() : 0;
}

void lab_page_step(LabPage* lab, const World* world, long every) {
    if (lab->timed)
        lab->spent += stages_now() - lab->since;
    lab->steps++;
    if (history_due(&lab->history, world, every)) {
        history_add(&lab->history, world, lab->timed ? lab->spent / lab->steps : (double)NAN);
        lab->spent = 0;
        lab->steps = 0;
    }
    lab_page_start(lab);
}

const Page* lab_page_take(LabPage* lab, const World* world) {
    snprintf(lab->page.title, sizeof lab->page.title, "Balloon %d", history_balloon(world));
    history_take(&lab->history, &lab->page);
    return &lab->page;
}

void lab_page_close(LabPage* lab) {
    free(lab);
}
