/* What is used of CVODE 7, as it is compiled in the wheel of scikit-sundae, which has no headers: `sunrealtype` is a double,
   `sunindextype` an int, a communicator an int. */
typedef struct SUNContext_ *SUNContext;
typedef struct N_Vector_ *N_Vector;
typedef struct SUNMatrix_ *SUNMatrix;
typedef struct SUNLinearSolver_ *SUNLinearSolver;
typedef struct SUNNonlinearSolver_ *SUNNonlinearSolver;
typedef int CVRhsFn(double, N_Vector, N_Vector, void *);

enum { CV_ADAMS = 1, CV_BDF = 2, CV_NORMAL = 1 };

int SUNContext_Create(int communicator, SUNContext *);
N_Vector N_VMake_Serial(int length, double *data, SUNContext);
double *N_VGetArrayPointer(N_Vector);
void N_VDestroy(N_Vector);
SUNMatrix SUNDenseMatrix(int rows, int columns, SUNContext);
void SUNMatDestroy(SUNMatrix);
SUNLinearSolver SUNLinSol_Dense(N_Vector, SUNMatrix, SUNContext);
int SUNLinSolFree(SUNLinearSolver);
SUNNonlinearSolver SUNNonlinSol_FixedPoint(N_Vector, int accelerations, SUNContext);
int SUNNonlinSolFree(SUNNonlinearSolver);
void *CVodeCreate(int method, SUNContext);
int CVodeInit(void *, CVRhsFn *, double t, N_Vector);
int CVodeSStolerances(void *, double relative, double absolute);
int CVodeSetLinearSolver(void *, SUNLinearSolver, SUNMatrix);
int CVodeSetNonlinearSolver(void *, SUNNonlinearSolver);
int CVodeSetMaxNumSteps(void *, long);
int CVodeSetStopTime(void *, double);
int CVode(void *, double t, N_Vector, double *reached, int task);
void CVodeFree(void **);
