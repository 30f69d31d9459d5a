#include "world/gas_flow.h"

#include "force/inflation.h"
#include "world/command.h"
#include "world/world.h"

void gas_flow_fill(World* world) {
    for (int b = 0; b < world->balloon_count; b++) {
        world->balloon[b].amount_before = world->balloon[b].body.inflation.amount;
        balloon_fill(&world->balloon[b], (double)(world->step_count + 1) * world->step);
    }
    for (int k = 0; k < command_count; k++)
        if (command_table[k].hold && (world->held >> k & 1))
            command_table[k].hold(world, world->step);
}

/// From one balloon to the other.
static void flow_through_pipe(World* world, const PipeDef* pipe) {
    Balloon* end[2] = {&world->balloon[(int)pipe->from], &world->balloon[(int)pipe->to]};
    const double energy = pipe->conductance * world->step *
                          (inflation_pressure(&end[0]->body) - inflation_pressure(&end[1]->body));
    for (int e = 0; e < 2; e++) {
        Inflation* gas = &end[e]->body.inflation;
        const double change =
            (e ? 1 : -1) * energy / (gas->unit * gas->temperature * gas->first_volume);
        end[e]->added_amount += change;
        gas->amount += change;
    }
}

void gas_flow_through(World* world) {
    for (unsigned k = 0; k < world->def.pipes_count; k++)
        if (world_time(world) >= world->def.pipes[k].start)
            flow_through_pipe(world, &world->def.pipes[k]);
    for (int b = 0; b < world->balloon_count; b++) {
        Balloon* balloon = &world->balloon[b];
        const InflationDef* inflation = balloon->def->inflation;
        if (inflation && inflation->leak > 0)
            balloon_leak(balloon, world->step);
        balloon->amount_after = balloon->body.inflation.amount;
    }
}

void gas_flow_reach(World* world, double share) {
    for (int b = 0; b < world->balloon_count; b++) {
        Balloon* balloon = &world->balloon[b];
        const double change = balloon->amount_after - balloon->amount_before;
        balloon->body.inflation.amount =
            share < 1 ? balloon->amount_before + share * change : balloon->amount_after;
    }
}
