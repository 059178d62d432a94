/* ranks_mpi.c - the adapter of ranks by MPI; see ranks.h. */
#include <mpi.h>

#include "rt/farm/ranks.h"

static bool mpi_begin(size_t *rank, size_t *count)
{
    int own, all, offered;

    if (MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &offered)
            != MPI_SUCCESS
        || offered < MPI_THREAD_FUNNELED)
        return false;
    MPI_Comm_rank(MPI_COMM_WORLD, &own);
    MPI_Comm_size(MPI_COMM_WORLD, &all);
    *rank = (size_t)own;
    *count = (size_t)all;
    return true;
}

static void mpi_send(size_t to, const uint64_t *words, size_t count)
{
    MPI_Send(words, (int)count, MPI_UINT64_T, (int)to, 0, MPI_COMM_WORLD);
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
    MPI_Finalize();
}

extern const struct ranks_adapter rt205_ranks_adapter;
const struct ranks_adapter rt205_ranks_adapter = { mpi_begin, mpi_send,
                                                   mpi_ready, mpi_receive,
                                                   mpi_end };
