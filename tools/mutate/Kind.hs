-- | The kinds of mistakes that are planted, each as what stands at a site and what may stand there
-- instead.
module Kind
  ( Kind (..),
    Form (..),
    operators,
    functions,
    number,
    condition,
    exchanged,
    elements,
  )
where

-- | A kind of site. What is planted there is a function of this type, in whose variants @x@, @y@
-- and @f@ are its arguments.
data Kind = Kind
  { kindName :: String,
    kindType :: String,
    -- | Its arguments, as the planted function binds them.
    kindArguments :: String,
    -- | What stands there, over the arguments.
    kindOriginal :: String,
    -- | What may stand there instead: its name, and the expression.
    kindVariants :: [(String, String)],
    -- | The fixity that the planted function is declared with, if it is an operator.
    kindFixity :: Maybe String
  }

-- | How a planted function takes the place of what stands at a site.
data Form
  = -- | It stands there instead: a name or an operator.
    Instead
  | -- | It is applied to what stands there.
    AppliedTo
  deriving stock (Eq, Show)

-- | Operators of the Prelude.
operators :: [(String, Kind)]
operators =
  [ (name, operator "comparison" "Original.Ord a => a -> a -> Original.Bool" name others "infix 4")
    | (name, others) <-
        [("<", ["<=", ">="]), ("<=", ["<", ">"]), (">", [">=", "<="]), (">=", [">", "<"])]
  ]
    ++ [ ( "==",
           operator "equality" "Original.Eq a => a -> a -> Original.Bool" "==" ["/="] "infix 4"
         ),
         ( "/=",
           operator "equality" "Original.Eq a => a -> a -> Original.Bool" "/=" ["=="] "infix 4"
         ),
         ("+", operator "addition" "Original.Num a => a -> a -> a" "+" ["-"] "infixl 6"),
         ("-", operator "addition" "Original.Num a => a -> a -> a" "-" ["+"] "infixl 6"),
         ( "&&",
           operator
             "connective"
             "Original.Bool -> Original.Bool -> Original.Bool"
             "&&"
             ["||"]
             "infixr 3"
         ),
         ( "||",
           operator
             "connective"
             "Original.Bool -> Original.Bool -> Original.Bool"
             "||"
             ["&&"]
             "infixr 2"
         )
       ]

operator :: String -> String -> String -> [String] -> String -> Kind
operator name signature original others =
  Kind name signature "x y" (applied original) [(other, applied other) | other <- others] . Just
  where
    applied symbol = "x Original." ++ symbol ++ " y"

-- | Functions of base.
functions :: [(String, Kind)]
functions =
  [ ("not", function "negation" "Original.Bool -> Original.Bool" "x" "not x" [("dropped", "x")]),
    ( "min",
      function
        "extreme"
        "Original.Ord a => a -> a -> a"
        "x y"
        "min x y"
        [("max", "Original.max x y")]
    ),
    ( "max",
      function
        "extreme"
        "Original.Ord a => a -> a -> a"
        "x y"
        "max x y"
        [("min", "Original.min x y")]
    ),
    ("minimum", extreme "minimum" "maximum"),
    ("maximum", extreme "maximum" "minimum"),
    ("take", prefix "take"),
    ("drop", prefix "drop"),
    ("when", check "when"),
    ("unless", check "unless")
  ]
  where
    function name signature arguments original variants =
      Kind name signature arguments ("Original." ++ original) variants Nothing
    extreme name other =
      function
        "extreme"
        "(Original.Foldable t, Original.Ord a) => t a -> a"
        "x"
        (name ++ " x")
        [(other, "Original." ++ other ++ " x")]
    prefix name =
      function
        "prefix"
        "Original.Int -> [a] -> [a]"
        "x y"
        (name ++ " x y")
        [ ("one more", "Original." ++ name ++ " (x Original.+ 1) y"),
          ("one less", "Original." ++ name ++ " (x Original.- 1) y")
        ]
    check name =
      function
        "check"
        "Original.Applicative f => Original.Bool -> f () -> f ()"
        "x y"
        (name ++ " x y")
        [("passed over", "Original.pure ()")]

-- | A whole number.
number :: Kind
number =
  Kind
    "number"
    "Original.Num a => a -> a"
    "x"
    "x"
    [("one more", "x Original.+ 1"), ("one less", "x Original.- 1")]
    Nothing

-- | A guard, or the condition of an @if@.
condition :: Kind
condition =
  Kind
    "condition"
    "Original.Bool -> Original.Bool"
    "x"
    "x"
    [("always", "Original.True"), ("never", "Original.False")]
    Nothing

-- | A function two of whose arguments are of one type, and stand side by side.
exchanged :: Kind
exchanged =
  Kind "exchange" "(a -> a -> b) -> a -> a -> b" "f x y" "f x y" [("exchanged", "f y x")] Nothing

-- | A list of this many elements, each of which may be dropped.
elements :: Int -> Kind
elements count =
  Kind
    "elements"
    "[a] -> [a]"
    "x"
    "x"
    [ ( "without the element " ++ show i,
        "Original.take " ++ show (i - 1) ++ " x Original.++ Original.drop " ++ show i ++ " x"
      )
      | i <- [1 .. min 6 count]
    ]
    Nothing
