/* ranks_mpi.c - adapts ranks.h to MPI. */
#include <mpi.h>
#include <stdlib.h>
#include <string.h>

#include "rt/jobs/ranks.h"

static bool mpi_begin(size_t *rank, size_t *count)
{
    int own, all, offered;
    if (MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &offered) != MPI_SUCCESS
        || offered < MPI_THREAD_FUNNELED)
        return false;
    MPI_Comm_rank(MPI_COMM_WORLD, &own);
    MPI_Comm_size(MPI_COMM_WORLD, &all);
    *rank = (size_t)own;
    *count = (size_t)all;
    return true;
}

/* The last message, which may still be in transit. Sending is asynchronous, so that the
 * sender does not wait until the receiver polls. */
static struct {
    MPI_Request request;
    uint64_t *words;
} sent = { MPI_REQUEST_NULL, NULL };

static void mpi_await_sent(void)
{
    MPI_Wait(&sent.request, MPI_STATUS_IGNORE);
    free(sent.words);
    sent.words = NULL;
}

static void mpi_send(size_t to, const uint64_t *words, size_t count)
{
    mpi_await_sent();
    sent.words = malloc(count * sizeof *words);
    if (!sent.words) {
        MPI_Send(words, (int)count, MPI_UINT64_T, (int)to, 0, MPI_COMM_WORLD);
        return;
    }
    memcpy(sent.words, words, count * sizeof *words);
    MPI_Isend(sent.words, (int)count, MPI_UINT64_T, (int)to, 0, MPI_COMM_WORLD,
              &sent.request);
}

static bool mpi_ready(size_t *from, size_t *count)
{
    MPI_Status status;
    int there, words;
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, &status);
    if (!there)
        return false;
    MPI_Get_count(&status, MPI_UINT64_T, &words);
    *from = (size_t)status.MPI_SOURCE;
    *count = (size_t)words;
    return true;
}

static void mpi_receive(size_t from, uint64_t *words, size_t count)
{
    MPI_Recv(words, (int)count, MPI_UINT64_T, (int)from, 0, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
}

static void mpi_end(void)
{
    mpi_await_sent();
    MPI_Finalize();
}

extern const struct ranks_adapter rt205_ranks_adapter;
const struct ranks_adapter rt205_ranks_adapter = { mpi_begin, mpi_send, mpi_ready,
                                                   mpi_receive, mpi_end };
